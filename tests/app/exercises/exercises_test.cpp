#include <catch2/catch.hpp>

#include <filesystem>
#include <set>

#include "app/exercises/check_exercise.hpp"
#include "app/exercises/formulas/mistakes.hpp"
#include "app/exercises/kinds.hpp"
#include "app/exercises/random.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/lesson/in_language.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"
#include "tests/app/program.hpp"

using namespace jw;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> exercise_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(JW_EXERCISES_FOLDER)) {
        if (entry.path().extension() == ".toml") { files.push_back(entry.path()); }
    }
    std::ranges::sort(files);
    return files;
}

ExercisesRead read_all(const fs::path& file) {
    ExercisesRead read = read_exercise_file(file);
    CAPTURE(file.string(), read.report());
    REQUIRE(read.diagnostics.empty());
    return read;
}

const char* const kHead = "format = 1\ntitle = \"T\"\n";

/// An exercise about two free bodies with an arm each.
std::string about_two_bodies(const std::string& more) {
    return std::string(kHead) + R"(
[[exercise]]
name = "x"
title = "X"
ask = "?"
scene = '''
format = 1
title = "S"
[[body]]
name = "a"
p = [1, 0, 0, 0]
[[body]]
name = "b"
p = [1, 0, 0, 0]
[[joint]]
name = "arms"
type = "n1"
bodies = ["a", "b"]
axis_i = [2, 1, 0]
axis_j = [0, 1, 2]
'''
)" + more;
}

/// An exercise about the joint of those arms.
std::string about_arms(const std::string& more) { return about_two_bodies("joint = \"arms\"\n" + more); }

}  // namespace

TEST_CASE(
    "Every shipped exercise is solved by its own answer, and names every known mistake", "[exercises]") {
    int count = 0;
    std::set<ExerciseKind> kinds;
    for (const fs::path& file : exercise_files()) {
        const ExercisesRead read = read_all(file);
        for (const Exercise& exercise : read.exercises) {
            const ExerciseCheck check = check_exercise(exercise, 2);
            CAPTURE(file.string(), exercise.name, check.problems);
            CHECK(check.holds());
            ++count;
            kinds.insert(exercise.kind);
        }
    }
    CHECK(count >= 60);
    CHECK(kinds.size() == kExerciseKinds.size());
}

TEST_CASE("Every lesson of the catalogue has an exercise", "[exercises]") {
    std::set<std::string> lessons;
    for (const IndexedExercise& exercise :
         exercises_of_course(fs::path(JW_EXERCISES_FOLDER).parent_path() / "catalogue")) {
        lessons.insert(exercise.lesson);
    }
    for (const std::string& lesson : names_of_lessons()) {
        CAPTURE(lesson);
        CHECK(lessons.contains(lesson));
    }
}

TEST_CASE("The same student, key and exercise give the same variant, others another one", "[exercises]") {
    const ExercisesRead read = read_exercises(
        about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\n"
                   "vary = [{ key = \"body.a.p\", nice = \"p\" }, { key = \"body.b.p\", nice = \"p\" }]\n"),
        "x.toml");
    CAPTURE(read.report());
    REQUIRE(read.exercises.size() == 1);
    const TaskMaker maker(read.exercises.front());
    std::set<std::string> scenes;
    for (int k = 0; k < 20; ++k) {
        const std::uint64_t seed = seed_of("key", std::to_string(k), "x");
        const Task task = maker.make(seed);
        REQUIRE(task.problem.empty());
        CHECK(maker.make(seed).variant.scene == task.variant.scene);
        scenes.insert(task.variant.scene);
    }
    CHECK(scenes.size() >= 18);
    CHECK(seed_of("ab", "c", "x") != seed_of("a", "bc", "x"));
}

TEST_CASE("Values to choose from are handed out with the digits that were written", "[exercises]") {
    const ExercisesRead read = read_exercises(
        about_arms(
            "kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\n"
            "vary = [{ key = \"joint.arms.axis_i\", values = [[0.4, 0, -1e-3], [0.1, 2.0, 12345.678]] }]\n"),
        "x.toml");
    CAPTURE(read.report());
    REQUIRE(read.exercises.size() == 1);
    const std::vector<std::string>& values = read.exercises.front().vary.front().values;
    CHECK(values == std::vector<std::string>{"[0.4, 0, -0.001]", "[0.1, 2.0, 12345.678]"});
}

TEST_CASE(
    "An exercise with alternatives asks one of them, each with words and a scene of its own", "[exercises]") {
    const std::string two =
        "kind = \"number\"\ncount = \"rank\"\nas_given = true\n"
        "[[exercise.alternative]]\nask = \"With a ball?\"\nhints = [\"A ball has three.\"]\n"
        "zh-Hant.ask = \"球？\"\ncount = \"rank\"\nas_given = true\n"
        "change = [{ key = \"joint.arms.type\", value = \"spherical\" }, "
        "{ key = \"joint.arms.axis_i\" }, { key = \"joint.arms.axis_j\" }, "
        "{ key = \"joint.arms.at\", value = [0, 0, 0] }]\n";
    const ExercisesRead read = read_exercises(about_two_bodies(two), "x.toml");
    CAPTURE(read.report());
    REQUIRE(read.exercises.size() == 1);
    const Exercise& exercise = read.exercises.front();
    REQUIRE(exercise.alternatives.size() == 1);
    CHECK(check_exercise(exercise, 2).problems.empty());
    const TaskMaker maker(exercise);
    std::set<double> answers;
    for (int k = 0; k < 20; ++k) {
        const std::uint64_t seed = seed_of("key", std::to_string(k), "x");
        const Task task = maker.make(seed);
        REQUIRE(task.problem.empty());
        CHECK(&maker.make(seed).exercise() == &task.exercise());
        const bool first = task.exercise().ask == "?";
        CHECK(task.exercise().name == "x");
        CHECK(task.exercise().title == "X");
        CHECK(task.exercise().hints.size() == (first ? 0 : 1));
        CHECK(task.asked.right(0, 0) == (first ? 1 : 3));
        answers.insert(task.asked.right(0, 0));
    }
    CHECK(answers.size() == 2);
    Exercise chinese = exercise;
    for_each_text(chinese, [](Text& text) { text.show("zh-Hant"); });
    CHECK(chinese.alternatives.front().ask == "球？");
}

TEST_CASE("What is wrong with an alternative is told", "[exercises]") {
    const auto report = [](const std::string& keys) {
        return read_exercises(
                   about_two_bodies(
                       "kind = \"number\"\ncount = \"rank\"\nas_given = true\n[[exercise.alternative]]\n" +
                       keys),
                   "x.toml")
            .report();
    };
    CHECK(report("count = \"rank\"\n").find("ask") != std::string::npos);
    CHECK(report("ask = \"?\"\n").find("what is asked") != std::string::npos);
    CHECK(report("ask = \"?\"\ncount = \"rank\"\ntitle = \"T\"\n").find("title") != std::string::npos);
    CHECK(
        report("ask = \"?\"\ncount = \"rank\"\nchange = [{ key = \"joint.C.type\", value = \"n2\" }]\n")
            .find("joint.C.type") != std::string::npos);
    CHECK(
        report("ask = \"?\"\ncount = \"rank\"\nchange = [{ key = \"joint.arms.type\", value = \"n9\" }]\n")
            .find("the changed scene is not a lesson") != std::string::npos);
}

TEST_CASE("Answers of all mistakes of a variant are more than ten tolerances apart", "[exercises]") {
    for (const fs::path& file : exercise_files()) {
        for (const Exercise& exercise : read_all(file).exercises) {
            if (exercise.kind == ExerciseKind::code || exercise.asked.empty() ||
                exercise.kind == ExerciseKind::choose) {
                continue;
            }
            const Task task = TaskMaker(exercise).make(seed_of("apart", "student", exercise.name));
            CAPTURE(exercise.name, task.problem);
            REQUIRE(task.problem.empty());
            std::vector<MatrixX> answers{task.asked.right};
            for (const KnownMistake& mistake : task.asked.mistakes) { answers.push_back(mistake.answer); }
            for (std::size_t a = 0; a < answers.size(); ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    CHECK(difference_from(answers[b], answers[a], task.asked) > 10.0 * task.asked.tolerance);
                }
            }
        }
    }
}

TEST_CASE("A mistake changes a formula in one thing", "[exercises]") {
    const auto first = [](const std::string& name, const std::string& formula) -> std::string {
        for (const FormulaMistake& mistake : formula_mistakes()) {
            if (mistake.name != name) { continue; }
            const std::vector<Altered> all = mistake.alter(math::own_math(formula));
            return all.empty() ? "" : math::write_plain(all.front().row);
        }
        return "no such mistake";
    };
    const auto plain = [](const std::string& formula) { return math::write_plain(math::own_math(formula)); };
    CHECK(first("local-for-global", "s_i^T d") == plain("s_i'^T d"));
    CHECK(first("global-for-local", "A_i s'_i") == plain("A_i s_i"));
    CHECK(first("bodies-exchanged", "s_i^T s_j") == plain("s_j^T s_i"));
    CHECK(first("term-dropped", "a + b") == plain("b"));
    CHECK(first("term-sign", "a - b") == plain("a + b"));
    CHECK(first("factor", "2 G \\dot{p}") == plain("1 G \\dot{p}"));
    CHECK(first("g-for-l", "G \\dot{p}") == plain("L \\dot{p}"));
    CHECK(first("dot", "G \\dot{p}") == plain("G p"));
    CHECK(first("tilde", "\\tilde{s}_i A_i") == plain("s_i A_i"));
    CHECK(first("matrix-transposed", "A_i s") == plain("A_i^T s"));
    CHECK(first("matrix-forgotten", "A_i s") == plain("s"));
    CHECK(first("axis-for-point", "s_i^B + r") == plain("s_i + r"));
    CHECK(first("order-of-product", "\\tilde{s}_i s_j") == plain("\\tilde{s}_j s_i"));
    CHECK(first("other-function", "\\sin \\theta") == plain("\\cos \\theta"));
    CHECK(first("square", "e_0^2") == plain("e_0"));
    CHECK(first("frame", "s + d") == "A (s + d)");
    CHECK(first("inverse", "J'^{-1} n'") == plain("n'"));
    CHECK(first("component", "s_{zi} + d") == plain("s_{xi} + d"));
    CHECK(first("tilde", "a + b").empty());
}

TEST_CASE("A term or a number that stands at several places is lost at all of them, too", "[exercises]") {
    const auto last = [](const std::string& name, const std::string& formula) -> std::string {
        for (const FormulaMistake& mistake : formula_mistakes()) {
            if (mistake.name == name) {
                return math::write_plain(mistake.alter(math::own_math(formula)).back().row);
            }
        }
        return "no such mistake";
    };
    const auto plain = [](const std::string& formula) { return math::write_plain(math::own_math(formula)); };
    CHECK(last("term-dropped", "(a + m) b - (c + m)") == plain("(a) b - (c)"));
    CHECK(last("factor", "2 a + 2 b + 3 c") == plain("1 a + 1 b + 3 c"));
    CHECK(last("factor", "2 a + 3 c") == plain("2 a + 1 c"));
    CHECK(last("not-normalised", "\\frac{y}{|y|}") == plain("y"));
}

TEST_CASE(
    "An exercise whose formula is wrong, or whose mistakes cannot be told apart, is refused", "[exercises]") {
    const ExercisesRead wrong = read_exercises(
        about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = 2 s_i^T s_j'\n"), "x.toml");
    REQUIRE(wrong.exercises.size() == 1);
    CHECK(check_exercise(wrong.exercises.front(), 1).problems.size() == 1);
    const ExercisesRead vague = read_exercises(
        about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\ntolerance = 0.9\n"
                   "vary = [{ key = \"body.a.p\", nice = \"p\" }]\n"),
        "x.toml");
    REQUIRE(vague.exercises.size() == 1);
    const ExerciseCheck check = check_exercise(vague.exercises.front(), 1);
    REQUIRE_FALSE(check.holds());
    CHECK(check.problems.front().find("no variant can be accepted") != std::string::npos);
}

TEST_CASE("A faulty exercise is reported at its place", "[exercises]") {
    const auto report = [](const std::string& text) { return read_exercises(text, "x.toml").report(); };
    CHECK(report(about_arms("kind = \"nubmer\"\n")).find("did you mean") != std::string::npos);
    CHECK(
        report(about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = s_k'\n"))
            .find("x.toml:4:1") != std::string::npos);
    CHECK(report(about_arms("kind = \"number\"\nas_given = true\n")).find("formula") != std::string::npos);
    CHECK(
        report(about_arms("kind = \"order\"\nitems = [\"a\"]\n")).find("expected 3 to 10") !=
        std::string::npos);
    CHECK(
        report(about_arms("kind = \"repair\"\nspoil = [{ key = \"joint.C.axis\", value = [1, 0, 0] }]\n"))
            .find("joint.C.axis") != std::string::npos);
    CHECK(
        report(about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\nvary = [{ key "
                          "= \"body.c.p\", nice = \"p\" }]\n"))
            .find("body.c.p") != std::string::npos);
    CHECK(report(kHead).find("[[exercise]]") != std::string::npos);
}

TEST_CASE(
    "An exercise names its lesson, within a lesson it is that one, and an unknown one is an error",
    "[exercises]") {
    const auto read = [](const std::string& keys, const std::string& file) {
        return read_exercises(
            about_arms("kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\n" + keys), file);
    };
    const ExercisesRead good = read("lesson = \"vectors/frames\"\n", "x.toml");
    REQUIRE(good.exercises.size() == 1);
    CHECK(good.exercises.front().lesson == "vectors/frames");
    const std::string wrong = read("lesson = \"vectors/frame\"\n", "x.toml").report();
    CHECK(wrong.find("there is no lesson 'vectors/frame'") != std::string::npos);
    CHECK(wrong.find("did you mean 'vectors/frames'") != std::string::npos);
    const std::string lesson =
        "format = 1\ntitle = \"L\"\n[[body]]\nname = \"a\"\n[[exercise]]\nname = \"x\"\n"
        "title = \"X\"\nkind = \"order\"\nask = \"?\"\nitems = [\"1\", \"2\", \"3\"]\n";
    const ExercisesRead within = read_exercises(lesson, "mine/own.toml");
    CAPTURE(within.report());
    REQUIRE(within.exercises.size() == 1);
    CHECK(within.exercises.front().lesson == "mine/own");
    const std::string twice =
        read_exercises(lesson + "lesson = \"vectors/frames\"\n", "mine/own.toml").report();
    CHECK(twice.find("belongs to that lesson") != std::string::npos);
}

TEST_CASE(
    "An exercise about files asks for something: the file as it is handed out does not meet all claims",
    "[exercises]") {
    const ExercisesRead read = read_exercises(
        std::string(kHead) + R"(
[[exercise]]
name = "x"
title = "X"
kind = "repair"
ask = "?"
scene = '''
format = 1
title = "S"
[[body]]
name = "a"
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "a"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[expect]]
rank = 5
'''
spoil = [{ key = "joint.hinge.axis", value = [0, 0, 2] }]
)",
        "x.toml");
    CAPTURE(read.report());
    REQUIRE(read.exercises.size() == 1);
    const ExerciseCheck check = check_exercise(read.exercises.front(), 1);
    REQUIRE_FALSE(check.holds());
    CHECK(check.problems.front().find("there is nothing to do") != std::string::npos);
}

TEST_CASE("docs/exercises.md names every mistake, and an unknown one is an error", "[exercises]") {
    const std::string docs = test::bytes_of(test::source_path("docs/exercises.md"));
    for (const std::string& name : mistake_names()) {
        CAPTURE(name);
        CHECK(docs.find("`" + name + "`") != std::string::npos);
    }
    const ExercisesRead read = read_exercises(
        about_arms(
            "kind = \"number\"\nas_given = true\nformula = '\\Phi = s_i^T s_j'\nmistakes = [\"singn\"]\n"),
        "x.toml");
    REQUIRE(read.exercises.size() == 1);
    const ExerciseCheck check = check_exercise(read.exercises.front(), 1);
    REQUIRE_FALSE(check.holds());
    CHECK(check.problems.front().find("did you mean 'sign'") != std::string::npos);
}
