#include <catch2/catch.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

const std::vector<std::string> kCommands{"list", "check", "step", "inspect", "solve", "render"};

}  // namespace

TEST_CASE("help of every command has an example that works", "[app][commands]") {
    for (const std::string& command : kCommands) {
        const Ran help = run({command, "--help"});
        CHECK(help.status == 0);
        INFO(help.out);
        CHECK(help.out.find("Example: jointwise " + command) != std::string::npos);
    }
    const Ran all = run({"--help"});
    CHECK(all.status == 0);
    for (const std::string& command : kCommands) {
        CHECK(all.out.find("  " + command + " ") != std::string::npos);
    }
}

TEST_CASE("bad usage is status 2 and says what was expected", "[app][commands]") {
    struct Case {
        std::vector<std::string> arguments;
        std::string says;
    };
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::vector<Case> cases{
        {{}, "jointwise: error: A subcommand is required\nhint: jointwise --help\n"},
        {{"chekc"},
         "jointwise: error: no command 'chekc'; expected one of list, check, step, inspect, solve, render\n"
         "hint: did you mean 'check'?\n"},
        {{"step"}, "jointwise: error: FILE is required\nhint: jointwise step --help\n"},
        {{"step", crank, "--until", "99"}, "jointwise: error: --until 99: the lesson has steps 0 to 9\n"},
        {{"inspect", crank, "--step", "99"}, "jointwise: error: --step 99: the lesson has steps 0 to 9\n"},
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
         "jointwise: error: --size 'big'; expected WIDTHxHEIGHT in pixels from 960x540 to 3840x2160, for "
         "example "
         "1920x1080\n"},
        {{"render", crank, "--out", folder.path("frames"), "--size", "7680x4320"},
         "jointwise: error: --size '7680x4320'; expected WIDTHxHEIGHT in pixels from 960x540 to 3840x2160, "
         "for "
         "example 1920x1080\n"},
        {{"render", crank, "--out", folder.path("frames"), "--fps", "nan"},
         "jointwise: error: --fps is not finite; expected 0.1 to 240\n"},
        {{"render", crank, "--out", folder.path("frames"), "--frames", "5:2"},
         "jointwise: error: --frames '5:2'; expected A:B, A:, :B or A with numbers from 0 to 35, the frames "
         "of "
         "this lesson\n"},
        {{"render", crank, "--out", crank},
         "jointwise: error: --out '" + crank +
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
        if (command == "list") { continue; }
        std::vector<std::string> arguments{command, wrong};
        if (command == "render") { arguments.insert(arguments.end(), {"--out", folder.path("frames")}); }
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
        CHECK(ran.err.find(" at t = 0 s after ") != std::string::npos);
        CHECK(ran.err.find("The parts cannot meet") != std::string::npos);
    }
    const Ran told = run({"step", file});
    CHECK(told.status == 3);
    CHECK(told.out.find("Joint rod cannot be closed. The last good pose is kept.") != std::string::npos);
    // nothing needs to close for a look at the state as it is
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

}  // namespace jw::test
