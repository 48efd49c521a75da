#pragma once

#include <string>

#include "app/exercises/kinds.hpp"
#include "lessons/exercise/progress_file.hpp"

/// Sentences about an exercise that stand in its tab, drawn or as text.
namespace jw::host {

/// "a number   ·   2 points   ·   solved 3 times, the last 2 in a row"
std::string facts_of(const Exercise& exercise, const ExerciseRecord& record);
/// Slides, and whether the program may be used.
std::string what_is_allowed(const Exercise& exercise);
/// Names of what a program reads.
std::string inputs_of_program(const Exercise& exercise);
/// The way to answer here, where it differs from a sheet on paper, and the unit.
std::string how_to_answer(const Task& task);
/// "Right.", "Not so: the sign is turned."
std::string title_of(const Judged& judged);

/// The answer is a lesson file.
bool is_file(ExerciseKind kind);
/// The answer is typed into the field and is made of numbers alone.
bool is_of_numbers(ExerciseKind kind);

}  // namespace jw::host
