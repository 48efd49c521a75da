#include "app/exercises/check_exercise.hpp"

#include <algorithm>

#include "app/exercises/kinds.hpp"
#include "app/exercises/random.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

void add_problem(ExerciseCheck& check, const std::string& what, const Judged& judged) {
    std::string text = what;
    for (const std::string& sentence : judged.feedback) { text += " | " + sentence; }
    check.problems.push_back(std::move(text));
}

void check_right(const Task& task, const KindOfExercise& kind, ExerciseCheck& check) {
    const Judged judged = kind.judge(task, kind.right(task));
    if (!judged.right || judged.share != 1.0) { add_problem(check, "its own answer is not right", judged); }
}

void check_mistakes(const Task& task, const KindOfExercise& kind, ExerciseCheck& check) {
    const std::vector<HandedMistake> mistakes = kind.mistakes(task);
    check.mistakes = std::max(check.mistakes, static_cast<int>(mistakes.size()));
    for (const HandedMistake& mistake : mistakes) {
        const Judged judged = kind.judge(task, mistake.handed);
        if (judged.right) {
            add_problem(check, "the mistake '" + mistake.name + "' counts as right", judged);
        } else if (judged.mistake != mistake.name) {
            add_problem(
                check, "the mistake '" + mistake.name + "' is taken for '" + judged.mistake + "'", judged);
        }
    }
}

void check_that_it_asks(const Task& task, ExerciseCheck& check) {
    if (is_judged_by_claims(task.exercise().kind) && is_solved_already(task)) {
        check.problems.emplace_back(
            "the scene already meets all claims when it is handed out, so there is nothing to do");
    }
}

void check_nonsense(const Task& task, const KindOfExercise& kind, ExerciseCheck& check) {
    for (const char* text :
         {"", "nonsense", "[[[[", "nan", "1e400", "{\"answers\": 3}", "-987654.321", "\x1b[31m"}) {
        const Judged judged = kind.judge(task, {text, {text}});
        if (judged.right || judged.share >= 1.0) {
            add_problem(check, "'" + std::string(text) + "' counts as right", judged);
        }
        if (!judged.right && judged.feedback.empty()) {
            add_problem(check, "nonsense gets no feedback", judged);
        }
    }
}

void measure(const Task& task, ExerciseCheck& check) {
    const MatrixX& right = task.asked.right;
    const int nonzero =
        right.size() == 0 ? 0 : static_cast<int>((right.cwiseAbs().array() > task.asked.tolerance).count());
    const bool first = check.variants == 0;
    check.least_nonzero = first ? nonzero : std::min(check.least_nonzero, nonzero);
    check.most_nonzero = std::max(check.most_nonzero, nonzero);
    check.least_condition =
        first ? task.asked.condition : std::min(check.least_condition, task.asked.condition);
    check.most_condition = std::max(check.most_condition, task.asked.condition);
}

/// Text that tells how similar the variants are.
std::string alike_text(const ExerciseCheck& check) {
    std::string text = std::to_string(check.draws) + (check.draws == 1 ? " draw" : " draws");
    if (check.most_nonzero > 0) {
        text += ", nonzero entries " + std::to_string(check.least_nonzero) + " to " +
                std::to_string(check.most_nonzero);
    }
    if (check.most_condition > 1.0) {
        text += ", condition " + number_text(check.least_condition, 2) + " to " +
                number_text(check.most_condition, 2);
    }
    return text;
}

/// Checks the variants of one exercise, without its alternatives.
void check_variants(const Exercise& exercise, int variants, ExerciseCheck& check) {
    const TaskMaker maker(exercise);
    const KindOfExercise& kind = kind_of(exercise.kind);
    for (int k = 0; k < variants && check.problems.empty(); ++k) {
        const Task task = maker.make(seed_of("check", std::to_string(k), exercise.name));
        check.draws += task.draws;
        if (!task.problem.empty()) {
            check.problems.push_back(task.problem);
            break;
        }
        measure(task, check);
        ++check.variants;
        check_right(task, kind, check);
        check_that_it_asks(task, check);
        check_mistakes(task, kind, check);
        check_nonsense(task, kind, check);
    }
}

}  // namespace

std::vector<ClaimResult> check_exercises(const std::vector<Exercise>& exercises, int variants) {
    std::vector<ClaimResult> results;
    for (const Exercise& exercise : exercises) {
        const ExerciseCheck check = check_exercise(exercise, variants);
        ClaimResult result;
        result.span = exercise.span;
        result.holds = check.holds();
        result.moment = "for " + std::to_string(variants) + (variants == 1 ? " student" : " students");
        result.subject = "exercise " + exercise.name;
        result.expected = "right answer and mistakes told apart";
        result.found = check.holds() ? std::to_string(check.mistakes) +
                                           (check.mistakes == 1 ? " mistake named; " : " mistakes named; ") +
                                           alike_text(check)
                                     : check.problems.front();
        results.push_back(std::move(result));
    }
    return results;
}

ExerciseCheck check_exercise(const Exercise& exercise, int variants) {
    ExerciseCheck check;
    check.name = exercise.name;
    Exercise alone = exercise;
    alone.alternatives.clear();
    check_variants(alone, variants, check);
    for (std::size_t k = 0; k < exercise.alternatives.size() && check.holds(); ++k) {
        check_variants(exercise.alternatives[k], variants, check);
        if (check.holds()) { continue; }
        check.problems.front() = "alternative " + std::to_string(k + 1) + ": " + check.problems.front();
    }
    return check;
}

}  // namespace jw
