#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/diagnostics.hpp"
#include "lessons/exercise/exercise.hpp"
#include "lessons/fields.hpp"

/// Exercise files: TOML as described in docs/exercises.md; the tables [[exercise]] of a lesson likewise.
namespace jw {

inline constexpr std::array kExerciseKinds{
    EnumWord<ExerciseKind>{ExerciseKind::number, "number", tr_later("a number")},
    EnumWord<ExerciseKind>{ExerciseKind::vector, "vector", tr_later("a vector")},
    EnumWord<ExerciseKind>{ExerciseKind::matrix, "matrix", tr_later("a matrix")},
    EnumWord<ExerciseKind>{ExerciseKind::pose, "pose", tr_later("r and p of a body")},
    EnumWord<ExerciseKind>{ExerciseKind::choose, "choose", tr_later("one of the choices")},
    EnumWord<ExerciseKind>{ExerciseKind::order, "order", tr_later("the right order")},
    EnumWord<ExerciseKind>{ExerciseKind::code, "code", tr_later("a program")},
    EnumWord<ExerciseKind>{ExerciseKind::repair, "repair", tr_later("a mended lesson file")},
    EnumWord<ExerciseKind>{ExerciseKind::build, "build", tr_later("a lesson file with joints added")},
    EnumWord<ExerciseKind>{ExerciseKind::experiment, "experiment", tr_later("a list of experiments")}};

/// Whether a file has tables [[exercise]].
enum class ExerciseTables { none, in_lesson, alone };
/// A file that cannot be read has none.
ExerciseTables exercise_tables_in(const std::filesystem::path& path);

/// The exercises of a file, or everything that is wrong with it: there are exercises only without errors.
struct ExercisesRead {
    Text title;
    std::vector<Exercise> exercises;
    std::vector<Diagnostic> diagnostics;  ///< by position
    std::string source;
    std::vector<ReadText> texts;  ///< all texts for people, of what could be read

    std::string report() const;
};

/// Never throws for bad input. Scenes are files named relative to the folder of `path`.
ExercisesRead read_exercise_file(const std::filesystem::path& path);
ExercisesRead read_exercises(std::string source, const std::filesystem::path& path);

/// The tables [[exercise]] of a lesson or of an exercise file.
/// @param folder  scenes are relative to it
/// @param scene   of exercises that name none; empty: they have to
std::vector<Exercise> read_exercise_tables(
    Fields& root, const std::filesystem::path& folder, const Exercise& defaults);

}  // namespace jw
