#pragma once

#include <filesystem>
#include <string>

namespace jw {

/// The text of a file, or why there is none.
struct FileText {
    std::string text;
    std::string problem;  ///< "there is no such file", empty if it was read
};

/// Reads a file, a pipe or a device to its end. Waiting is limited: two seconds for a pipe that no program
/// writes to, and eight seconds for one whose writer sends nothing.
/// @param most  bytes; a longer file is a problem
FileText read_file_text(const std::filesystem::path& path, std::size_t most);

}  // namespace jw
