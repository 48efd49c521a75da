#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/fields/fields.hpp"
#include "lessons/lesson/exercise.hpp"

/// Exercise files: TOML as described in docs/exercises.md; the tables [[exercise]] of a lesson likewise.
namespace jw {

/// Tables [[exercise]] of a file: none, in a lesson, or in a file of their own.
enum class ExerciseTables { none, in_lesson, alone };
/// A file that cannot be read has none.
ExerciseTables exercise_tables_in(const std::filesystem::path& path);

/// The exercises of a file and its diagnostics. If there are errors, there are no exercises.
struct ExercisesRead : FileRead {
    Text title;
    std::vector<Exercise> exercises;
};

/// Reads an exercise file; never throws for bad input. Scenes are named relative to the folder of `path`.
ExercisesRead read_exercise_file(const std::filesystem::path& path);
ExercisesRead read_exercises(std::string source, const std::filesystem::path& path);

/// The tables [[exercise]] of a lesson or of an exercise file.
/// @param folder    scenes are relative to it
/// @param defaults  has the scene of exercises that do not name one; if it is empty, each must name one
std::vector<Exercise> read_exercise_tables(
    Fields& root, const std::filesystem::path& folder, const Exercise& defaults);

}  // namespace jw

/// Parts of the reader of exercises.
namespace jw::reading {

/// Keys `vary` and `condition_below`.
void read_draws(Fields& fields, Exercise& exercise);
/// The keys that belong to the kind of the exercise.
void read_answer(Fields& fields, Exercise& exercise);
/// A list of changes of a scene: { key = "joint.B.axis", value = [1, 0, 0] }.
std::vector<SceneEdit> read_edits(Fields& fields, std::string_view key);

}  // namespace jw::reading
