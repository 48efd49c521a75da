#pragma once

#include <filesystem>
#include <string>

/// Services of the browser around the page.
namespace jw::web {

/// Offers a file to the user as a download. The file stays where it is.
void download(const std::filesystem::path& file);
/// Copies a text to the clipboard.
void copy(const std::string& text);
/// Begins to measure time against error in another copy of the program, which does nothing else; a copy that
/// is already measuring is ended. The results arrive at jw_measured with this number.
void begin_measuring(int number, const std::string& lesson, const std::string& treatment);
/// Ends the measurement of this number, if it is running.
void end_measuring(int number);
/// Reports results, as JSON, to the page around this copy of the program.
void tell_measured(const std::string& news);
/// Writes an error to the console of the browser.
void log(const std::string& text);

}  // namespace jw::web
