#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/exercises/task.hpp"

/// Programs that read the input of an exercise and write answers, with a place for the student's code.
namespace jw {

/// Endings of the languages that have a starter.
inline constexpr std::array<std::string_view, 4> kStarterEndings{".py", ".cpp", ".m", ".js"};

/// A program for an exercise that reads its input, answers each case with 0, and writes the answers; it needs
/// only its language.
/// @param ending  ".py", ".cpp", ".m" or ".js"
/// @return empty for another ending
std::string starter_text(const Task& task, std::string_view ending);

/// Writes a starter and, beside it, the input of the cases. Existing files stay.
/// @return what was done, or why it was not, for people
std::string write_starter(const Task& task, const std::filesystem::path& file);

}  // namespace jw
