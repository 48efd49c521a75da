#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include "app/exercises/formulas/mistakes.hpp"
#include "app/exercises/kinds.hpp"
#include "app/exercises/random.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/exercise/read_exercises.hpp"

using namespace jw;

namespace {

namespace fs = std::filesystem;

bool has_numbers_of_formula(const Exercise& exercise) {
    const bool numbers = exercise.kind == ExerciseKind::number || exercise.kind == ExerciseKind::vector ||
                         exercise.kind == ExerciseKind::matrix || exercise.kind == ExerciseKind::pose;
    return numbers && !exercise.formula.empty();
}

Judged judged_numbers(const Task& task, const MatrixX& value) {
    return judge_value(task, {written(value), {}});
}

/// Number of answers with two wrong terms that get the words of both mistakes; others get those of a single
/// mistake that leads to the same answer, or none.
int named_pairs(const Task& task) {
    constexpr std::size_t kTried = 6;
    const std::vector<KnownMistake> pairs = mistakes_in_two_terms(task.variant);
    const std::size_t step = std::max<std::size_t>(1, pairs.size() / kTried);
    int named = 0;
    for (std::size_t k = 0; k < pairs.size(); k += step) {
        const MatrixX& answer = pairs[k].answer;
        if (answer.size() != task.asked.right.size() || !answer.allFinite()) { continue; }
        const Judged judged = judged_numbers(task, answer);
        CAPTURE(tr(pairs[k].says), judged.mistake, judged.feedback);
        if (judged.right) {
            CHECK(difference_from(task.asked.right, answer, task.asked) <= 1.001 * task.asked.tolerance);
        } else if (judged.mistake == kTwoTermsName) {
            CHECK(judged.feedback.front() == tr(pairs[k].says));
            CHECK(judged.share == 0.0);
            ++named;
        } else if (!judged.mistake.empty()) {
            CHECK(std::ranges::any_of(task.asked.mistakes, [&](const KnownMistake& mistake) {
                return mistake.name == judged.mistake;
            }));
        }
    }
    return named;
}

}  // namespace

TEST_CASE(
    "Two terms that are wrong are named, and right answers and single mistakes keep their names",
    "[exercises]") {
    int exercises = 0;
    int named = 0;
    for (const auto& entry : fs::directory_iterator(JW_EXERCISES_FOLDER)) {
        if (entry.path().extension() != ".toml") { continue; }
        const ExercisesRead read = read_exercise_file(entry.path());
        for (const Exercise& exercise : read.exercises) {
            if (!has_numbers_of_formula(exercise)) { continue; }
            const Task task = TaskMaker(exercise).make(seed_of("two", "student", exercise.name));
            CAPTURE(exercise.name, task.problem);
            REQUIRE(task.problem.empty());
            CHECK(judged_numbers(task, task.asked.right).right);
            for (const KnownMistake& mistake : task.asked.mistakes) {
                CHECK(judged_numbers(task, mistake.answer).mistake == mistake.name);
            }
            const int more = named_pairs(task);
            named += more;
            exercises += more > 0 ? 1 : 0;
        }
    }
    CAPTURE(exercises, named);
    CHECK(exercises >= 15);
    CHECK(named >= 40);
}

TEST_CASE("A missing term and a wrong sign are both named", "[exercises]") {
    const ExercisesRead read = read_exercise_file(fs::path(JW_EXERCISES_FOLDER) / "jacobians.toml");
    const TaskMaker maker(*std::ranges::find(read.exercises, "p1-gamma", &Exercise::name));
    const Task task = maker.make(5);
    const std::vector<KnownMistake> pairs = mistakes_in_two_terms(task.variant);
    const auto two = std::ranges::find_if(pairs, [](const KnownMistake& pair) {
        const std::string says = tr(pair.says);
        return says.find("is missing") != std::string::npos &&
               says.find("has the wrong sign") != std::string::npos;
    });
    REQUIRE(two != pairs.end());
    const Judged judged = judged_numbers(task, two->answer);
    CHECK_FALSE(judged.right);
    CHECK(judged.mistake == "two-terms");
    CHECK(judged.title == "two terms are wrong");
    CHECK(judged.feedback.front() == tr(two->says));
    // an answer that no known mistake leads to has no name
    CHECK(judged_numbers(task, two->answer + 0.37 * task.asked.right).mistake.empty());
}
