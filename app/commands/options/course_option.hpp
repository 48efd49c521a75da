#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "lessons/exercise/handed_in.hpp"
#include "lessons/lesson/exercise.hpp"

namespace jw {

/// Exercises of several files, in their order.
struct ExerciseSet {
    std::string title;  ///< of the first file
    std::vector<Exercise> exercises;
};
/// @throws CommandError (bad_input) with all mistakes, including names that occur twice
ExerciseSet exercises_of(const std::vector<std::string>& files);

/// The key of a course. @throws CommandError (bad_input) with all mistakes
CourseKey key_of(const std::string& file);

}  // namespace jw
