#include "app/exercises/kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

constexpr const char* kNumber =
    tr_later("Write a number, such as 0.5236, 1/3 or sqrt(3)/2, with its unit where it has one.");
constexpr const char* kVector = tr_later("Write the numbers in brackets: [1, 2, 3].");
constexpr const char* kMatrix = tr_later("Write the rows in brackets: [[1, 2], [3, 4]].");

KindOfExercise of_values(ExerciseKind kind, const char* hand_in) {
    return {kind, hand_in, right_value, mistaken_values, judge_value, ""};
}

/// Number of significant digits at which rounding stays within the tolerance, whatever the first digit is:
/// for 1.0, rounding is half a unit of the last digit.
int digits_for(double relative_tolerance) {
    return static_cast<int>(
        std::max(1.0, std::ceil(1.0 - elementary::log10(2.0 * relative_tolerance) - 1e-9)));
}

}  // namespace

bool is_measured(ExerciseKind kind) {
    return kind == ExerciseKind::number || kind == ExerciseKind::vector || kind == ExerciseKind::matrix ||
           kind == ExerciseKind::pose;
}

bool is_judged_by_claims(ExerciseKind kind) {
    return kind == ExerciseKind::repair || kind == ExerciseKind::build || kind == ExerciseKind::experiment;
}

Judged not_understood(std::string why) {
    Judged judged;
    judged.understood = false;
    judged.feedback.push_back(std::move(why));
    return judged;
}

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
            ExerciseKind::repair, tr_later("Hand in the repaired lesson file. Change as little as possible."),
            right_repair, mistaken_repairs, judge_repair, ".toml"},
        KindOfExercise{
            ExerciseKind::build,
            tr_later("Hand in the lesson file with your joints added. Leave the rest as it is."), right_build,
            mistaken_builds, judge_build, ".toml"},
        KindOfExercise{
            ExerciseKind::experiment,
            tr_later("Write the list of experiments in the form that 'jointwise try --try' takes."),
            right_experiment, mistaken_experiments, judge_experiment, ""}};
    for (const KindOfExercise& entry : kKinds) {
        if (entry.kind == kind) { return entry; }
    }
    throw std::invalid_argument("a kind of exercise without an entry");
}

MatrixX in_shape_of(const MatrixX& right, const MatrixX& given) {
    const bool both_vectors =
        std::min(right.rows(), right.cols()) == 1 && std::min(given.rows(), given.cols()) == 1;
    const bool turned = given.rows() == right.cols() && given.cols() == right.rows();
    return both_vectors && turned ? MatrixX(given.transpose()) : given;
}

std::string accuracy_text(const Task& task) {
    constexpr std::array kWords{
        "",
        tr_later("One"),
        tr_later("Two"),
        tr_later("Three"),
        tr_later("Four"),
        tr_later("Five"),
        tr_later("Six"),
        tr_later("Seven"),
        tr_later("Eight")};
    const Asked& asked = task.asked;
    if (!is_measured(task.exercise().kind) || asked.tolerance <= 0.0 || asked.right.size() == 0) {
        return {};
    }
    const bool several = asked.right.size() > 1;
    if (task.exercise().absolute) {
        const std::string off = number_text(asked.tolerance, 3) + unit_behind(asked);
        return several ? tr("Each number may be off by {0}.", off) : tr("It may be off by {0}.", off);
    }
    // the tolerance itself is a fraction of the answer, and would tell it
    const int digits = digits_for(task.exercise().tolerance);
    const auto k = static_cast<std::size_t>(digits);
    const std::string count = k < kWords.size() ? tr(kWords[k]) : std::to_string(digits);
    return several
               ? tr_count(
                     digits, "{1} significant digit in each number is enough.",
                     "{1} significant digits in each number are enough.", count)
               : tr_count(
                     digits, "{1} significant digit is enough.", "{1} significant digits are enough.", count);
}

}  // namespace jw
