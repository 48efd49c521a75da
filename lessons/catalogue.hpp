#pragma once

#include <filesystem>
#include <vector>

/// The lessons that come with the program.
namespace jw {

/// Folder of the shipped lessons: the environment variable JOINTWISE_LESSONS, else the one of the source
/// tree that the program was built from.
std::filesystem::path catalogue_folder();

/// Lesson files (*.toml) below a folder, sorted by path; empty if the folder is not there or cannot be read.
std::vector<std::filesystem::path> lessons_below(const std::filesystem::path& folder);

}  // namespace jw
