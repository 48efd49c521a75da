#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Which exercises belong to which lessons, without reading the exercises themselves.
namespace jw {

/// Name of the folder of files of exercises, beside that of the lessons.
inline constexpr const char* kExercisesFolder = "exercises";

/// Where an exercise is found.
struct IndexedExercise {
    std::filesystem::path file;
    std::string name;
    std::string lesson;  ///< that it belongs to, "vectors/frames"; may be empty

    bool operator==(const IndexedExercise&) const = default;
};

/// Name of a lesson by which exercises refer to it: its folder and its file, "vectors/frames".
std::string lesson_name(const std::filesystem::path& file);
/// Names of all lessons of the catalogue, sorted.
std::vector<std::string> names_of_lessons();

/// The tables [[exercise]] of a file that have a name, in their order; of a lesson they belong to it. A file
/// that cannot be read has none, and nothing else is checked.
std::vector<IndexedExercise> exercises_named_in(const std::filesystem::path& file);

/// Files of exercises in a folder, those in its folders not included, sorted; none if it cannot be read.
std::vector<std::filesystem::path> exercise_files_in(const std::filesystem::path& folder);

/// Files of exercises of a folder with lessons: those of the folder `exercises` beside it, or beside the
/// folder around it, sorted.
std::vector<std::filesystem::path> exercise_files_of(const std::filesystem::path& lessons_folder);

/// All exercises of a folder with lessons: those of exercise_files_of, then those within its lessons.
std::vector<IndexedExercise> exercises_of_course(const std::filesystem::path& lessons_folder);

/// Those of one lesson.
std::vector<IndexedExercise> exercises_of_lesson(
    const std::vector<IndexedExercise>& exercises, const std::string& lesson);

}  // namespace jw
