#include "app/exercises/kinds.hpp"

#include "lessons/text/translatable.hpp"

namespace jw {

namespace {

constexpr const char* kNumber =
    tr_later("Write a number, such as 0.5236, 1/3 or sqrt(3)/2, with its unit where it has one.");
constexpr const char* kVector = tr_later("Write the numbers in brackets: [1, 2, 3].");
constexpr const char* kMatrix = tr_later("Write the rows in brackets: [[1, 2], [3, 4]].");

KindOfExercise of_values(ExerciseKind kind, const char* hand_in) {
    return {kind, hand_in, right_value, mistaken_values, judge_value, ""};
}

}  // namespace

const KindOfExercise& kind_of(ExerciseKind kind) {
    static const std::array kKinds{
        of_values(ExerciseKind::number, kNumber),
        of_values(ExerciseKind::vector, kVector),
        of_values(ExerciseKind::matrix, kMatrix),
        of_values(ExerciseKind::pose, tr_later("Write r and p as seven numbers: [x, y, z, e0, e1, e2, e3].")),
        of_values(
            ExerciseKind::choose,
            tr_later("Write the number of the choice, from 1; x, y and z are 1, 2 and 3.")),
        of_values(
            ExerciseKind::order, tr_later("Write the numbers of the items in their right order: [3, 1, 2].")),
        KindOfExercise{
            ExerciseKind::code,
            tr_later("Hand in a program: .py, .cpp, .m or .js. It reads JSON and writes JSON."), right_output,
            mistaken_outputs, judge_output, "program"},
        KindOfExercise{
            ExerciseKind::repair, tr_later("Hand in the mended lesson file. Change as little as possible."),
            right_repair, mistaken_repairs, judge_repair, ".toml"},
        KindOfExercise{
            ExerciseKind::build,
            tr_later("Hand in the lesson file with your joints added. Leave the rest as it is."), right_build,
            mistaken_builds, judge_build, ".toml"},
        KindOfExercise{
            ExerciseKind::experiment,
            tr_later("Write the list of experiments, as after 'jointwise try --try'."), right_experiment,
            mistaken_experiments, judge_experiment, ""}};
    for (const KindOfExercise& entry : kKinds) {
        if (entry.kind == kind) { return entry; }
    }
    throw std::invalid_argument("a kind of exercise without an entry");
}

}  // namespace jw
