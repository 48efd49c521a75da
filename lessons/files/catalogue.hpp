#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Location of the files that come with the program and are read while it runs, its lessons first of all.
/// Only catalogue.cpp knows it.
namespace jw {

/// Data folder of the program in the file `program`: `../share/jointwise` relative to the program's folder,
/// as in an installation; or else `share/jointwise` of the build tree that contains the program. If neither
/// exists, the first of the two, so that a message can say what is missing.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

/// The data folder of the running program.
const std::filesystem::path& data_folder();

/// Folder of the shipped lessons: the environment variable JOINTWISE_LESSONS, or else `catalogue` in the
/// lessons of `data_folder`.
std::filesystem::path catalogue_folder();

/// True for names that begin with a dot: programs keep such files for themselves.
bool is_hidden(const std::filesystem::path& path);

/// Lesson files (*.toml except course.toml) below a folder, sorted by path; empty if the folder does not
/// exist or cannot be read. Hidden files and folders are left out.
std::vector<std::filesystem::path> lessons_below(const std::filesystem::path& folder);

/// Paths of named lessons. A name that is the file name of a lesson in `shipped`, without .toml, stands for
/// that lesson; any other name is a path.
std::vector<std::filesystem::path> named_lessons(
    const std::vector<std::string>& names, const std::vector<std::filesystem::path>& shipped);

}  // namespace jw
