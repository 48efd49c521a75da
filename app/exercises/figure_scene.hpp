#pragma once

#include <optional>

#include "app/exercises/task.hpp"

/// The figure of an exercise.
namespace jw {

/// Scene to draw for an exercise; it gives no answer away.
struct FigureScene {
    Lesson lesson;
    bool as_given = false;  ///< the poses of the file; else everything put together
};

/// The scene as the student gets it: of a repair the sick one. Nothing for a formula at random states, an
/// order, or an exercise without a scene.
std::optional<FigureScene> figure_scene(const Task& task);

/// A lesson file is handed out with the exercise (kinds.hpp: handed_out).
bool hands_out_file(const Exercise& exercise);

}  // namespace jw
