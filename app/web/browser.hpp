#pragma once

#include <filesystem>
#include <string>

/// Services of the browser around the page.
namespace jw::web {

/// Gives a file to the person as a download. It stays where it is.
void download(const std::filesystem::path& file);
/// Puts a text into the clipboard.
void copy(const std::string& text);
/// Tells the console of the browser about a fault.
void log(const std::string& text);

}  // namespace jw::web
