#pragma once

#include <filesystem>

/// Location of the files that come with the program and are read while it runs. Only this file knows it.
namespace jw {

/// Data folder of the program in the file `program`: `../share/jointwise` relative to the program's folder,
/// as in an installation; or else `share/jointwise` of the build tree that contains the program. If neither
/// exists, the first of the two, so that a message can say what is missing.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

/// The data folder of the running program.
const std::filesystem::path& data_folder();

}  // namespace jw
