#pragma once

#include <filesystem>
#include <string>

/// Files of students, which are not trusted.
namespace jw {

struct PlainFile {
    std::string text;
    bool absent = false;
    std::string problem;  ///< why it was not read, one sentence; empty if it was
};

/// Reads a regular file of at most `most` bytes; links, folders, pipes and devices are refused.
PlainFile read_plain_file(const std::filesystem::path& path, std::size_t most);

}  // namespace jw
