#include <catch2/catch.hpp>

#include <fstream>
#include <set>

#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

const std::vector<std::string> kCommands{
    "open",   "list",       "new",  "check",  "explain", "schema",   "keys",  "sheet", "grade",
    "step",   "inspect",    "try",  "newton", "solve",   "simulate", "bench", "plot",  "render",
    "doctor", "completion", "rest", "manual", "export",  "snapshot", "site"};

/// A command that can write JSON, with its arguments besides the format.
std::vector<std::vector<std::string>> commands_with_json(const std::string& driven) {
    const std::string pendulum = lesson_path("dynamics/simple-pendulum.toml");
    return {{"step", driven},     {"inspect", driven},
            {"try", driven},      {"newton", driven},
            {"solve", driven},    {"simulate", pendulum, "--duration", "0.1", "--samples", "2"},
            {"rest", pendulum},   {"check", driven},
            {"explain", "JW301"}, {"list"},
            {"doctor"},           {"keys", "joint"}};
}

Ran run_with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
}

}  // namespace

TEST_CASE("help of every command has an example that works", "[app][commands]") {
    for (const std::string& command : kCommands) {
        const Ran help = run({command, "--help"});
        CHECK(help.status == 0);
        INFO(help.out);
        CHECK(help.out.find("Example: jointwise " + command) != std::string::npos);
        CHECK_THAT(help.out, !Catch::Contains("Excludes:  ") && !Catch::Contains("Excludes: \n"));
    }
    const Ran all = run({"--help"});
    CHECK(all.status == 0);
    for (const std::string& command : kCommands) {
        CHECK(all.out.find("  " + command + " ") != std::string::npos);
    }
}

TEST_CASE("What is written is said by --format, and --output and --json say the same", "[app][commands]") {
    const Folder folder;
    for (const auto& command : commands_with_json(folder.file("crank.toml", kCrank))) {
        CAPTURE(command);
        const Ran format = run_with(command, {"--format", "json"});
        CHECK(format.status == 0);
        CHECK(format.out.starts_with("{"));
        CHECK(run_with(command, {"--output", "json"}).out == format.out);
        CHECK(run_with(command, {"--json"}).out == format.out);
        const Ran both = run_with(command, {"--format", "json", "--json"});
        CHECK(both.status == 2);
        CHECK_THAT(both.err, Catch::Contains("--format excludes --json"));
    }
}

TEST_CASE("Every command has a section of its own in docs/command-line.md", "[app][commands]") {
    std::ifstream file(std::string(JW_SOURCE_ROOT) + "/docs/command-line.md");
    std::set<std::string> sections;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("## ")) { sections.insert(line.substr(3)); }
    }
    for (const std::string& command : kCommands) {
        INFO(command);
        CHECK(sections.contains(command));
    }
}

TEST_CASE("No help and no hint names another option for the format than --format", "[app][commands]") {
    for (const std::string& command : kCommands) {
        const Ran help = run({command, "--help"});
        INFO(help.out);
        CHECK(help.out.find("--output") == std::string::npos);
        CHECK(help.out.find("--json") == std::string::npos);
    }
    const Folder folder;
    const Ran slip = run({"step", folder.file("crank.toml", kCrank), "--outptu", "json"});
    CHECK(slip.status == 2);
    CHECK(slip.err.find("--output'") == std::string::npos);
}

TEST_CASE("bad usage is status 2 and says what was expected", "[app][commands]") {
    struct Case {
        std::vector<std::string> arguments;
        std::string says;
    };
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::vector<Case> cases{
        {{"chekc"},
         "jointwise: error: no command 'chekc'; expected one of open, list, new, check, explain, keys, "
         "schema, "
         "step, "
         "inspect, try, "
         "newton, solve, simulate, rest, bench, plot, render, export, snapshot, site, "
         "sheet, grade, doctor, completion, manual\n"
         "hint: did you mean 'check'?\n"},
        {{"step"}, "jointwise: error: FILE is required\nhint: jointwise step --help\n"},
        {{"step", crank, "--until", "99"}, "jointwise: error: --until 99: the lesson has steps 0 to 9\n"},
        {{"inspect", crank, "--step", "99"}, "jointwise: error: --step 99: the lesson has steps 0 to 9\n"},
        {{"step", crank, "--until", "-1"},
         "jointwise: error: --until: -1 is below 0; expected a step, counted from 0\n"
         "hint: jointwise step --help\n"},
        {{"inspect", crank, "--step", "-1"},
         "jointwise: error: --step: -1 is below 0; expected a step, counted from 0\n"
         "hint: jointwise inspect --help\n"},
        {{"inspect", crank, "--step", "1", "--as-given"},
         "jointwise: error: --step excludes --as-given\nhint: jointwise inspect --help\n"},
        {{"inspect", crank, "--time", "nan"},
         "jointwise: error: --time is not finite; expected a time in s\n"},
        {{"solve", crank, "--step", "0"},
         "jointwise: error: --step is not positive; expected a time in s\nhint: jointwise solve --help\n"},
        {{"solve", crank, "--from", "1", "--to", "0"},
         "jointwise: error: --to is before --from; expected a time at or after it\nhint: jointwise solve "
         "--help\n"},
        {{"solve", crank, "--step", "1e-9"},
         "jointwise: error: --step is so small that there would be more than a million rows\n"
         "hint: jointwise solve --help\n"},
        {{"render", crank, "--out", folder.path("frames"), "--size", "big"},
         "jointwise: error: --size 'big'; expected WIDTHxHEIGHT in pixels from 960x540 to 15360x8640, or "
         "turned, "
         "for example 1920x1080\n"},
        {{"render", crank, "--out", folder.path("frames"), "--size", "30720x17280"},
         "jointwise: error: --size '30720x17280'; expected WIDTHxHEIGHT in pixels from 960x540 to "
         "15360x8640, "
         "or "
         "turned, for example 1920x1080\n"},
        {{"render", crank, "--out", folder.path("frames"), "--fps", "nan"},
         "jointwise: error: --fps is not finite; expected 0.1 to 240\n"},
        {{"render", crank, "--out", folder.path("frames"), "--frames", "5:2"},
         "jointwise: error: --frames '5:2'; expected A:B, A:, :B or A with numbers from 0 to 35, the frames "
         "of "
         "this lesson\n"},
        {{"render", crank, "--out", folder.path("frames"), "--frames", ""},
         "jointwise: error: --frames ''; expected A:B, A:, :B or A with numbers from 0 to 35, the frames of "
         "this lesson\n"},
        {{"render", crank, "--out", crank},
         "jointwise: error: '" + crank +
             "' cannot be made a folder: Not a directory; expected a folder that "
             "can be written\n"},
    };
    for (const Case& c : cases) {
        const Ran ran = run(c.arguments);
        INFO((c.arguments.empty() ? "no arguments" : c.arguments.front()));
        CHECK(ran.status == 2);
        CHECK(ran.err == c.says);
        CHECK(ran.out.empty());
    }
    CHECK_FALSE(std::filesystem::exists(folder.path("frames")));
}

TEST_CASE("a wrong lesson is status 2 with file, line and column, for every command", "[app][commands]") {
    const Folder folder;
    const std::string wrong = folder.file("wrong.toml", "format = 1\ntitle = \"t\"\ncolor = 3\n");
    for (const std::string& command : kCommands) {
        // these read no lesson
        const std::vector<std::string> others{"list",  "new",   "doctor",     "explain", "schema", "keys",
                                              "grade", "sheet", "completion", "rest",    "manual", "site"};
        if (std::ranges::find(others, command) != others.end()) { continue; }
        std::vector<std::string> arguments{command, wrong};
        if (command == "render") { arguments.insert(arguments.end(), {"--out", folder.path("frames")}); }
        if (command == "plot") { arguments.insert(arguments.end(), {"--out", folder.path("plot.png")}); }
        if (command == "export") { arguments.insert(arguments.end(), {"--csv", "-"}); }
        if (command == "snapshot") {
            arguments = {"snapshot", "record", wrong, "--golden", folder.path("golden")};
        }
        const Ran ran = run(arguments);
        CHECK(ran.status == 2);
        CHECK(ran.err.find(wrong + ":3:1: error: unknown key 'color'") != std::string::npos);
        CHECK(ran.out.empty());
    }
    CHECK_FALSE(std::filesystem::exists(folder.path("frames")));
}

TEST_CASE("what cannot be closed is status 3 and says which row, when, how far and why", "[app][commands]") {
    const Folder folder;
    const std::string file = folder.file("short.toml", kTooShort);
    for (const std::string command : {"inspect", "solve"}) {
        const Ran ran = run({command, file});
        CHECK(ran.status == 3);
        INFO(ran.err);
        CHECK(ran.err.starts_with(file + ": Joint rod cannot be closed: "));
        CHECK(ran.err.find("cannot all be closed at t = 0 s") != std::string::npos);
        CHECK(ran.err.find("the points of rod stay 2 m off their distance") != std::string::npos);
        CHECK(ran.err.find("pivot · s · x is off by -1.4e+00") != std::string::npos);
    }
    const Ran told = run({"step", file});
    CHECK(told.status == 3);
    CHECK(told.out.find("Joint rod cannot be closed. The last good pose is kept.") != std::string::npos);
    // the state as given can be inspected although a joint cannot be closed
    CHECK(run({"inspect", file, "--as-given"}).status == 0);
}

TEST_CASE("a claim that does not hold is status 1, with its place and both numbers", "[app][commands]") {
    const Folder folder;
    const std::string file = folder.file(
        "claim.toml", std::string(kCrank) + "[[expect]]\nrank = 5\ndof = 0\nwhy = \"One is driven.\"\n");
    const Ran ran = run({"check", file});
    CHECK(ran.status == 1);
    CHECK(
        ran.out == file +
                       ": 1 of 2 claims hold\n"
                       "  FAILS after drive        rank                   expected 5, found 6\n"
                       "        " +
                       file +
                       ":20:8\n"
                       "        One is driven.\n"
                       "  holds after drive        dof                    0\n");
}

TEST_CASE("check goes on after a file that is wrong", "[app][commands]") {
    const Folder folder;
    const std::string good = folder.file("good.toml", std::string(kCrank) + "[[expect]]\nrank = 6\n");
    const Ran ran = run({"check", folder.path("missing.toml"), good});
    CHECK(ran.status == 2);
    CHECK(ran.out.find("1 of 1 claim holds") != std::string::npos);
    CHECK(ran.err.find("missing.toml: error: there is no such file") != std::string::npos);
}

TEST_CASE("one picture is not several", "[app][commands]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const Ran ran = run({"render", crank, "--out", folder.path("one"), "--size", "960x540", "--frames", "0"});
    CHECK(ran.status == 0);
    CHECK(ran.err == "1 picture and manifest.json in " + folder.path("one") + "\n");
}

TEST_CASE("a time far outside the motion is said to be that, and how far it went", "[app][commands]") {
    const std::string file = lesson_path("loops/four-bar.toml");
    const Ran far = run({"inspect", file, "--time", "1e8"});
    CHECK(far.status == 3);
    CHECK_THAT(
        far.err,
        Catch::Contains(": t = 1e+08 s lies far outside the lesson's motion, which goes from 0 s to 4 s. The "
                        "motion can be followed as far as "));
    // up to its own length beyond its ends the motion goes on as within
    CHECK(run({"inspect", file, "--time", "7.9"}).status == 0);
}

TEST_CASE("a lesson that was written proves what the lesson that was read does", "[app][commands]") {
    const Folder folder;
    for (const auto& path : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(path);
        REQUIRE(read.lesson.has_value());
        const std::string file = folder.file("written.toml", lesson_text(*read.lesson));
        const Ran of_the_first = run({"check", path.string()});
        const Ran of_the_second = run({"check", file});
        INFO(path << '\n' << of_the_second.out << of_the_second.err);
        CHECK(of_the_second.status == 0);
        const auto verdicts = [](const Ran& ran) { return ran.out.substr(ran.out.find('\n')); };
        CHECK(verdicts(of_the_second) == verdicts(of_the_first));
    }
}

}  // namespace jw::test
