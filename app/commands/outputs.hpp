#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jw {

/// Looks at an output before anything is computed: whether it can be written, and whether it is one of the
/// files that are read, under this name or another one, link or not. Fonts are read by everything that draws.
/// @param option  that names the output
/// @throws CommandError (bad_input) or std::runtime_error
void check_output(
    const std::string& option, const std::filesystem::path& output,
    const std::vector<std::filesystem::path>& inputs);

/// True if `path` is the regular file that standard output or standard error is redirected into.
bool is_own_output(const std::filesystem::path& path);

}  // namespace jw
