#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The lessons that come with the program.
namespace jw {

/// Folder of the shipped lessons: the environment variable JOINTWISE_LESSONS, else the one of `data_folder`.
std::filesystem::path catalogue_folder();

/// True for names that begin with a dot: what programs keep beside files is not for people.
bool is_hidden(const std::filesystem::path& path);

/// Lesson files (*.toml but no course.toml) below a folder, sorted by path; empty if the folder is not there
/// or cannot be read. What is hidden in it is left out.
std::vector<std::filesystem::path> lessons_below(const std::filesystem::path& folder);

/// Paths of named lessons: by their file's name without .toml where `shipped` has them, else paths as they
/// are.
std::vector<std::filesystem::path> named_lessons(
    const std::vector<std::string>& names, const std::vector<std::filesystem::path>& shipped);

}  // namespace jw
