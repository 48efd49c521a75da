#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Folders of kept inputs and lists of words.
namespace jw::fuzz {

/// Words of a dictionary as libFuzzer reads it: one in quotes on a line, with \xNN, \\ and \" in it; lines
/// that begin with # are comments.
/// @throws std::runtime_error if the file cannot be read, a line is none of these, or there is no word
std::vector<std::string> read_words(const std::filesystem::path& file);

/// Kept input of a target, with the name of its file.
struct Kept {
    std::string name;
    std::string text;
};
std::vector<Kept> kept_inputs(const std::filesystem::path& folder);

/// The whole of a file. @throws std::runtime_error if it cannot be read
std::string bytes_of(const std::filesystem::path& file);

}  // namespace jw::fuzz
