#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Finds which exercises belong to which lessons, without reading the exercises themselves.
namespace jw {

/// Name of the folder of exercise files, beside that of the lessons.
inline constexpr const char* kExercisesFolder = "exercises";

/// Place of an exercise.
struct IndexedExercise {
    std::filesystem::path file;
    std::string name;
    std::string lesson;  ///< lesson that it belongs to, "vectors/frames"; may be empty

    bool operator==(const IndexedExercise&) const = default;
};

/// Name by which exercises refer to a lesson: its folder and its file, "vectors/frames".
std::string lesson_name(const std::filesystem::path& file);
/// Names of all lessons of the catalogue, sorted.
std::vector<std::string> names_of_lessons();

/// The tables [[exercise]] of a file that have a name, in their order; in a lesson file, they belong to that
/// lesson. A file that cannot be read has none. Nothing else is checked.
std::vector<IndexedExercise> exercises_named_in(const std::filesystem::path& file);

/// Exercise files directly in a folder, sorted; none if it cannot be read.
std::vector<std::filesystem::path> exercise_files_in(const std::filesystem::path& folder);

/// Exercise files of a folder of lessons, sorted: those in the folder `exercises` beside it, or beside its
/// parent folder.
std::vector<std::filesystem::path> exercise_files_of(const std::filesystem::path& lessons_folder);

/// All exercises of a folder of lessons: those of exercise_files_of, then those in its lessons.
std::vector<IndexedExercise> exercises_of_course(const std::filesystem::path& lessons_folder);

/// The exercises of one lesson.
std::vector<IndexedExercise> exercises_of_lesson(
    const std::vector<IndexedExercise>& exercises, const std::string& lesson);

}  // namespace jw
