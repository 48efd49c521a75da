#pragma once

#include <filesystem>
#include <string>

#include "app/exercises/task.hpp"

namespace jw {

/// A program for an exercise that reads its input, does nothing, and writes answers; in the language of the
/// ending: .py, .m, .js or .cpp.
/// @return empty for another ending
std::string starter_text(const Task& task, const std::string& ending);

/// Writes a starter and, beside it, the input of the cases; files that are there stay.
/// @return what was done, or why it was not, for people
std::string write_starter(const Task& task, const std::filesystem::path& file);

}  // namespace jw
