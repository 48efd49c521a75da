#pragma once

#include <array>
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

/// Starter in C++, with its own small JSON reader, since C++ has none.
/// @param inputs  a line for each input of a case
std::string cpp_starter_text(const std::string& inputs);

}  // namespace jw
