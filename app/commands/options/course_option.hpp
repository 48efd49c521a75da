#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/exercises/grading/grade.hpp"
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

/// The exercises with the secret of the key. @throws CommandError (bad_input) if no variants can be drawn
ReadyCourse ready_or_refused(const CourseKey& key, const ExerciseSet& set);

}  // namespace jw
