#pragma once

#include <string>

#include "app/exercises/kinds.hpp"
#include "lessons/exercise/handed_in.hpp"

/// Sentences about an exercise in its tab, drawn or as text.
namespace jw::host {

/// "a number   ·   2 points   ·   solved 3 times, the last 2 in a row"
std::string facts_of(const Exercise& exercise, const ExerciseRecord& record);
/// Slides, and whether the program may be used.
std::string what_is_allowed(const Exercise& exercise);
/// Names of the inputs of a program.
std::string inputs_of_program(const Exercise& exercise);
/// How to answer in the program, where this differs from paper, and the unit.
std::string how_to_answer(const Task& task);
/// "Right.", "Not correct: wrong sign."
std::string title_of(const Judged& judged);

/// True if the answer is a lesson file.
bool is_file(ExerciseKind kind);
/// True if the answer is typed into the field and consists only of numbers.
bool is_of_numbers(ExerciseKind kind);

}  // namespace jw::host
