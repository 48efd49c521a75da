#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jw {

/// Checks an output before anything is computed: it must be writable, and must not be one of the files that
/// are read, under any name, link or not. Fonts count, too, since everything that draws reads them.
/// @param option  names the output
/// @throws CommandError (bad_input) or std::runtime_error
void check_output(
    const std::string& option, const std::filesystem::path& output,
    const std::vector<std::filesystem::path>& inputs);

/// True if `path` is the regular file that standard output or standard error is redirected into.
bool is_own_output(const std::filesystem::path& path);

}  // namespace jw
