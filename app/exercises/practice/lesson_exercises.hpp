#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "lessons/exercise/exercise.hpp"

/// The exercises of a lesson.
namespace jw {

/// An exercise that can be practised.
struct PracticeExercise {
    std::shared_ptr<const Exercise> exercise;
    std::string key;  ///< of its record: its file and its name, "exercises/vectors/global-vector"
};

struct LessonExercises {
    std::vector<PracticeExercise> exercises;
    std::string problem;  ///< what is wrong with files of exercises, one line for each file
};

/// Key of an exercise's record.
std::string record_key(const std::filesystem::path& file, const std::string& name);

/// Reads the exercises of a lesson: those within it, and those of the course that name it.
/// @param lessons_folder  of the course
LessonExercises exercises_to_practise(
    const std::filesystem::path& lesson_file, const std::filesystem::path& lessons_folder,
    const std::stop_token& stop);

}  // namespace jw
