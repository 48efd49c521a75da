#pragma once

#include <filesystem>
#include <string>

#include "app/exercises/task.hpp"

namespace jw {

/// Writes a starter and, beside it, the input of the cases. Existing files stay.
/// @return what was done, or why it was not, for people
std::string write_starter(const Task& task, const std::filesystem::path& file);

}  // namespace jw
