#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lessons/lesson/exercise.hpp"

/// The exercises of a lesson.
namespace jw {

/// An exercise that can be practised.
struct PracticeExercise {
    std::shared_ptr<const Exercise> exercise;
    std::string key;  ///< key of its record: its file and its name, "exercises/vectors/global-vector"
};

struct LessonExercises {
    std::vector<PracticeExercise> exercises;
    std::string problem;  ///< what is wrong with files of exercises, one line for each file
};

/// Key of an exercise's record.
std::string record_key(const std::filesystem::path& file, const std::string& name);

/// Reads the exercises of a lesson file by file: those within it, and those of the course that name it.
class LessonExercisesReader {
public:
    /// @param lessons_folder  of the course
    LessonExercisesReader(
        const std::filesystem::path& lesson_file, const std::filesystem::path& lessons_folder);

    /// Reads the next file. @return false if there is none
    bool read();
    const LessonExercises& found() const { return found_; }

private:
    std::string lesson_;
    std::vector<std::filesystem::path> files_;  ///< files still to be read, the last one first
    LessonExercises found_;
};

}  // namespace jw
