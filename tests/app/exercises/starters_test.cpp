#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "app/exercises/grading/grade.hpp"
#include "app/exercises/run/languages.hpp"
#include "app/exercises/starters.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

namespace {

/// What a student writes for "n1-row-code", −s_jᵀ A_i s̃′_i = (s′_i × A_iᵀ s_j)ᵀ, in place of the line that
/// returns 0.
const std::map<std::string, std::string> kBodies{
    {".py", R"(
    b = [sum(A_i[r][c] * s_j[r] for r in range(3)) for c in range(3)]
    a = s_i_local
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
)"},
    {".cpp", R"(
    double b[3] = {0, 0, 0};
    for (int r = 0; r < 3; ++r) {
        for (int k = 0; k < 3; ++k) { b[k] += A_i[r][k] * s_j[r][0]; }
    }
    const double a[3] = {s_i_local[0][0], s_i_local[1][0], s_i_local[2][0]};
    return {{a[1] * b[2] - a[2] * b[1]}, {a[2] * b[0] - a[0] * b[2]}, {a[0] * b[1] - a[1] * b[0]}};
)"},
    {".m", "\n  x = cross (s_i_local, A_i' * s_j);\n"},
    {".js", R"(
  const b = [0, 1, 2].map(k => A_i[0][k] * s_j[0] + A_i[1][k] * s_j[1] + A_i[2][k] * s_j[2]);
  const a = s_i_local;
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
)"}};

/// The starter with a body in place of the line that answers 0.
std::string filled_in(const std::string& starter, const std::string& ending) {
    const std::string zero = ending == ".m"     ? "\n  x = 0;"
                             : ending == ".cpp" ? "\n    return {{0}};"
                                                : "return 0";
    const std::size_t at = starter.find(zero);
    REQUIRE(at != std::string::npos);
    const std::size_t line = starter.rfind('\n', at == 0 ? 0 : at);
    return starter.substr(0, line) + kBodies.at(ending) + starter.substr(starter.find('\n', at + 1) + 1);
}

/// True if programs with this ending can run here; warns if they cannot.
bool can_run(const std::string& ending) {
    const exercises::SandboxAvailability& sandbox = exercises::sandbox_availability();
    const std::string why =
        sandbox.available ? exercises::missing_tool(*exercises::language_of(ending)) : sandbox.reason;
    if (!why.empty()) { WARN("no starter " << ending << " is run: " << why); }
    return why.empty();
}

/// The endings of kStarterEndings that run on this machine.
std::vector<std::string> endings_that_run() {
    std::vector<std::string> endings(kStarterEndings.begin(), kStarterEndings.end());
    std::erase_if(endings, [](const std::string& ending) { return !can_run(ending); });
    return endings;
}

std::vector<Exercise> programs_asked_for() {
    std::vector<Exercise> all;
    for (const auto& file : std::filesystem::directory_iterator(JW_EXERCISES_FOLDER)) {
        if (file.path().extension() != ".toml") { continue; }
        std::ranges::copy_if(
            read_exercise_file(file.path()).exercises, std::back_inserter(all),
            [](const Exercise& exercise) { return exercise.kind == ExerciseKind::code; });
    }
    return all;
}

}  // namespace

TEST_CASE(
    "A starter with the right body filled in gets all points, in every language", "[exercises][starter]") {
    const std::vector<Exercise> all = programs_asked_for();
    const Task task = TaskMaker(*std::ranges::find(all, "n1-row-code", &Exercise::name)).make(3);
    REQUIRE(task.problem.empty());
    const Folder folder;
    for (const auto& [ending, body] : kBodies) {
        if (!can_run(ending)) { continue; }
        const std::string program = filled_in(starter_text(task, ending), ending);
        const Judged judged = judge_program_file(task, folder.file("mine" + ending, program));
        CAPTURE(ending, program, judged.feedback);
        CHECK(judged.right);
    }
}

TEST_CASE(
    "What a program prints in passing is shown where its answers were expected", "[exercises][starter]") {
    const std::vector<Exercise> all = programs_asked_for();
    const Task task = TaskMaker(*std::ranges::find(all, "n1-row-code", &Exercise::name)).make(3);
    const Folder folder;
    if (!can_run(".py")) { return; }
    const auto feedback = [&](const std::string& before) {
        const std::string program = before + starter_text(task, ".py");
        return judge_program_file(task, folder.file("mine.py", program)).feedback;
    };
    CHECK_THAT(feedback("print('x = 3')\n").back(), Catch::Contains("begins with \"x = 3\"."));
    CHECK_THAT(feedback("raise SystemExit\n").back(), Catch::Contains("wrote nothing"));
}

TEST_CASE("Every starter runs as it is and answers each state", "[exercises][starter]") {
    const std::vector<Exercise> all = programs_asked_for();
    CHECK(all.size() >= 9);
    const std::vector<std::string> endings = endings_that_run();
    const Folder folder;
    for (const Exercise& exercise : all) {
        const Task task = TaskMaker(exercise).make(5);
        REQUIRE(task.problem.empty());
        for (const std::string& ending : endings) {
            const std::string starter = starter_text(task, ending);
            CAPTURE(exercise.name, ending);
            CHECK_FALSE(starter.empty());
            const Judged judged = judge_program_file(task, folder.file("mine" + ending, starter));
            CAPTURE(judged.feedback);
            CHECK(judged.understood);
        }
    }
}

TEST_CASE(
    "A sheet brings the starters of its programs, and says how they are judged", "[exercises][starter]") {
    const Folder folder;
    const std::string key = folder.file("key.toml", "format = 1\nsecret = \"quite a secret\"\n");
    const Ran ran = run(
        {"sheet", std::string(JW_EXERCISES_FOLDER) + "/jacobians.toml", "--key", key, "--out",
         folder.path("out"), "--student", "ann", "--no-figures", "--solution"});
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    for (const char* name :
         {"n1-row-code.py", "n1-row-code.cpp", "n1-row-code.m", "n1-row-code-input.json"}) {
        CAPTURE(name);
        CHECK_FALSE(bytes_of(folder.path(std::string("out/ann/starters/") + name)).empty());
    }
    CHECK_THAT(
        bytes_of(folder.path("out/ann/sheet.md")),
        Catch::Contains("The starter program in the folder starters"));
    CHECK_THAT(
        bytes_of(folder.path("out/ann/solution/sheet.html")), Catch::Contains("It is tested in 24 cases"));
}

}  // namespace jw::test
