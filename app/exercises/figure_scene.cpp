#include "app/exercises/figure_scene.hpp"

#include "app/exercises/kinds.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace {

/// False without a scene, for an order, and for a formula at random states, which a figure cannot show.
bool has_figure(const Exercise& exercise) {
    return !exercise.scene.empty() && exercise.kind != ExerciseKind::code &&
           exercise.kind != ExerciseKind::order;
}

bool is_as_given(const Task& task) {
    if (hands_out_file(task.exercise()) && task.exercise().asked.empty()) { return true; }
    const std::vector<Claim>& claims = task.variant.lesson.claims;
    return claims.empty() || !std::holds_alternative<AfterAddition>(claims.front().when);
}

}  // namespace

bool hands_out_file(const Exercise& exercise) {
    if (is_judged_by_claims(exercise.kind)) { return true; }
    if (exercise.kind == ExerciseKind::code || exercise.kind == ExerciseKind::order) { return false; }
    return !exercise.asked.empty() && exercise.formula.empty();
}

std::optional<FigureScene> figure_scene(const Task& task) {
    const Exercise& exercise = task.exercise();
    if (!has_figure(exercise)) { return std::nullopt; }
    if (!hands_out_file(exercise) || !exercise.asked.empty()) {
        return FigureScene{task.variant.lesson, is_as_given(task)};
    }
    ReadResult read = read_lesson(handed_out(task), exercise.name + ".toml");
    if (!read.lesson) { return std::nullopt; }
    return FigureScene{std::move(*read.lesson), true};
}

}  // namespace jw
