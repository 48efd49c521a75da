#include "app/exercises/practice/verdict.hpp"

#include <cmath>

#include "app/exercises/answers/given_value.hpp"
#include "app/exercises/value_latex.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

/// The answer as a matrix of the expected shape; empty if it has another shape.
MatrixX understood_value(const Task& task, const std::string& text) {
    const Asked& asked = task.asked;
    const GivenValue read = read_given_value(text, asked.unit);
    if (!read.problem.empty()) { return {}; }
    const MatrixX given = in_shape_of(asked.right, read.value);
    const bool fits = given.rows() == asked.right.rows() && given.cols() == asked.right.cols();
    return fits ? given : MatrixX();
}

/// p or −p, whichever is nearer to the given value.
MatrixX nearest_right(const Asked& asked, const MatrixX& given) {
    MatrixX right = asked.right;
    if (!asked.sign_of_p || right.rows() < 7) { return right; }
    const auto p = right.bottomRows(4);
    const auto p_given = given.bottomRows(4);
    if ((p + p_given).norm() < (p - p_given).norm()) { right.bottomRows(4) *= -1.0; }
    return right;
}

std::vector<std::vector<bool>> differing(const Asked& asked, const MatrixX& given) {
    const MatrixX right = nearest_right(asked, given);
    std::vector<std::vector<bool>> wrong(static_cast<std::size_t>(given.rows()));
    for (Eigen::Index r = 0; r < given.rows(); ++r) {
        for (Eigen::Index c = 0; c < given.cols(); ++c) {
            wrong[static_cast<std::size_t>(r)].push_back(
                !(std::abs(given(r, c) - right(r, c)) <= std::max(asked.tolerance, 1e-9)));
        }
    }
    return wrong;
}

}  // namespace

AnswerVerdict verdict_of(const Task& task, const Handed& handed, Judged judged) {
    AnswerVerdict verdict{std::move(judged), {}, {}};
    if (!is_measured(task.exercise().kind) || !verdict.judged.understood) { return verdict; }
    verdict.given = understood_value(task, handed.text);
    const bool can_differ = verdict.given.size() > 1 && !verdict.judged.right;
    if (can_differ) { verdict.wrong = differing(task.asked, verdict.given); }
    return verdict;
}

AnswerVerdict verdict_on(const Task& task, const Handed& handed) {
    return verdict_of(task, handed, kind_of(task.exercise().kind).judge(task, handed));
}

std::string solution_words(const Task& task) {
    const Exercise& exercise = task.exercise();
    switch (exercise.kind) {
        case ExerciseKind::code: return "$" + task.asked.latex + "$";
        case ExerciseKind::repair: return spoiled_text(exercise);
        case ExerciseKind::build: return exercise.solution;
        case ExerciseKind::experiment: {
            std::string list;
            for (const std::string& action : exercise.does) { list += (list.empty() ? "" : "\n") + action; }
            return list;
        }
        case ExerciseKind::choose:
        case ExerciseKind::order: return written(task.asked.right);
        default: break;
    }
    const std::string value = "$" + value_latex(task.asked.right) + "$" + unit_behind(task.asked);
    return task.asked.latex.empty() ? value : "$" + task.asked.latex + "$\n" + value;
}

}  // namespace jw
