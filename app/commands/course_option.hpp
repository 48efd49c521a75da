#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"
#include "lessons/exercise/exercise.hpp"
#include "lessons/exercise/handed_in.hpp"

namespace jw {

/// Exercises of files, in their order.
struct ExerciseSet {
    std::string title;  ///< of the first file
    std::vector<Exercise> exercises;
};
/// @throws CommandError (bad_input) with everything that is wrong, names that occur twice included
ExerciseSet exercises_of(const std::vector<std::string>& files);

/// The key of a course. @throws CommandError (bad_input) with everything that is wrong
CourseKey key_of(const std::string& file);

}  // namespace jw
