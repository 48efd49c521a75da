#pragma once

#include <filesystem>
#include <string>

/// Services of the browser around the page.
namespace jw::web {

/// Gives a file to the person as a download. It stays where it is.
void download(const std::filesystem::path& file);
/// Puts a text into the clipboard.
void copy(const std::string& text);
/// Begins to measure what a digit costs in another copy of the program, which does nothing else; one that
/// measures already is ended. What it finds comes to jw_measured with this number.
void begin_measuring(int number, const std::string& lesson, const std::string& treatment);
/// Ends the measurement of this number, if it is under way.
void end_measuring(int number);
/// Tells the page around this copy of the program what was measured, as JSON.
void tell_measured(const std::string& news);
/// Tells the console of the browser about a fault.
void log(const std::string& text);

}  // namespace jw::web
