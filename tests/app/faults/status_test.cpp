#include <catch2/catch.hpp>

#include "app/commands/help/doctor.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

/// Two bodies that must be 3 m apart and meet: falls at the first moment.
constexpr const char* kGoesNowhere = R"(
[dynamics]
gravity = [0, 0, -9.81]
duration = 1
point = { body = "arm", at = [0, 0, 0] }
)";

}  // namespace

TEST_CASE("Whatever ends with status 3 says so on standard error", "[app][commands]") {
    const Folder folder;
    const std::string file = folder.file("short.toml", kTooShort);
    std::string masses = kTooShort;
    masses.replace(masses.find("name = \"arm\""), 12, "name = \"arm\"\nmass = 1\ninertia = [1, 1, 1]");
    const std::string falls = folder.file("falls.toml", masses + kGoesNowhere);
    const std::vector<std::vector<std::string>> lines{
        {"step", file},
        {"step", file, "--format", "json"},
        {"solve", file},
        {"solve", file, "--format", "json"},
        {"inspect", file},
        {"inspect", file, "--time", "1"},
        {"newton", file},
        {"newton", file, "--format", "csv"},
        {"plot", file, "--out", folder.path("y.png")},
        {"render", file, "--out", folder.path("frames"), "--size", "960x540", "--frames", "0"},
        {"plot", file, "--of", "residuals", "--out", folder.path("x.csv")},
        {"plot", file, "--of", "residuals", "--out", folder.path("x.png")},
        {"simulate", falls},
        {"simulate", falls, "--format", "json"},
        {"step", falls},
        {"bench", falls, "--method", "rk4"},
    };
    for (const auto& line : lines) {
        std::string text;
        for (const std::string& argument : line) { text += ' ' + argument; }
        const Ran ran = run(line);
        CAPTURE(text, ran.status, ran.err);
        CHECK(ran.status == 3);
        CHECK(ran.err.size() > 20);
        CHECK(ran.err.ends_with('\n'));
    }
    // the part of the story before the failure is told
    const Ran part = run({"step", file, "--until", "1"});
    CHECK(part.status == 0);
    CHECK(part.err.empty());
}

TEST_CASE("doctor tells lessons that are missing from lessons that are damaged", "[app][doctor]") {
    const Folder folder;
    using State = LessonsReport::State;
    const LessonsReport none = examine_lessons(folder.path("none"));
    CHECK(none.state == State::missing);
    CHECK_THAT(none.problem, Catch::Contains("there is no lesson (*.toml) below '" + folder.path("none")));
    folder.file("lessons/a.toml", kCrank);
    const LessonsReport right = examine_lessons(folder.path("lessons"));
    CHECK(right.state == State::right);
    CHECK(right.count == 1);
    CHECK(right.problem.empty());
    folder.file("lessons/b.toml", std::string(kCrank).substr(0, 100));
    const LessonsReport damaged = examine_lessons(folder.path("lessons"));
    CHECK(damaged.state == State::damaged);
    CHECK(damaged.count == 1);
    CHECK_THAT(damaged.problem, Catch::StartsWith("1 of 2 lessons cannot be read, the first: "));
    CHECK_THAT(damaged.problem, Catch::Contains("b.toml:"));

    Diagnosis diagnosis;
    diagnosis.lessons = damaged;
    CHECK(exit_of(diagnosis) == Exit::bad_input);
    CHECK_THAT(verdict_of(diagnosis), Catch::StartsWith("something needed is damaged"));
    diagnosis.lessons = none;
    CHECK_THAT(verdict_of(diagnosis), Catch::StartsWith("something needed is missing"));
}

TEST_CASE("doctor says on standard error that something is wrong", "[app][doctor]") {
    std::ostringstream out;
    std::ostringstream err;
    const auto window = [] {
        SurfaceReport report;
        report.name = "window";
        report.state = SurfaceReport::State::draws_wrong;
        report.problem = "the picture is blank";
        return report;
    };
    CHECK(run_program({"doctor"}, Streams{out, err, false}, window) == 3);
    CHECK(
        err.str() == "jointwise: error: a surface draws incorrectly; 'jointwise doctor' says what and why\n");
}

}  // namespace jw::test
