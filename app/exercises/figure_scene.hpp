#pragma once

#include <optional>

#include "app/exercises/task.hpp"

/// The figure of an exercise.
namespace jw {

/// Scene to draw for an exercise; it does not give the answer away.
struct FigureScene {
    Lesson lesson;
    bool as_given = false;  ///< true: the poses of the file; false: everything assembled
};

/// The scene as the student gets it: for a repair with its faults. Nothing for a formula at random states, an
/// order, or an exercise without a scene.
std::optional<FigureScene> figure_scene(const Task& task);

/// True if a lesson file is handed out with the exercise (kinds.hpp: handed_out).
bool hands_out_file(const Exercise& exercise);

}  // namespace jw
