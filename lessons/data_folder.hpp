#pragma once

#include <filesystem>

/// Where the files are that come with the program and are read while it runs. No other file knows.
namespace jw {

/// The folder of data that belongs to a program in the file `program`: `../share/jointwise` seen from the
/// program's folder, as it is installed; else `share/jointwise` of the build tree that the program lies in.
/// Where neither is there, the first of the two, so that a message can say what is missing.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

/// The folder of data of the running program.
const std::filesystem::path& data_folder();

}  // namespace jw
