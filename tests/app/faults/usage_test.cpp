#include <catch2/catch.hpp>

#include <random>
#include <regex>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

/// Names of functions, types and macros of the libraries that the program is made of, and of the system.
const std::regex& library_names() {
    static const std::regex names(
        "\\bE[A-Z]{4,}\\b|\\bGL_[A-Z]|\\bgl[A-Z][a-z]+[A-Z]|\\bFT_[A-Z]|\\bIM_[A-Z]|\\bOSMesa[A-Z]|CLI::|"
        "CLI11|std::|"
        "toml::|toml\\+\\+|Eigen|nlohmann|json\\.exception|basic_string|vector::|stoi|stod|bad_alloc|"
        "filesystem error|"
        "Could not convert|what\\(\\)|_M_|\\bINVALID_|SIG[A-Z]{3,}");
    return names;
}

void check_words(const Ran& ran) {
    std::smatch match;
    const bool names_library = std::regex_search(ran.err, match, library_names());
    INFO(ran.err);
    CHECK_FALSE(names_library);
    if (ran.status >= 2) { CHECK_FALSE(ran.err.empty()); }
}

struct Case {
    std::vector<std::string> arguments;
    std::string says;
};

}  // namespace

TEST_CASE("Numbers on the command line that are none, or out of range, are named with what was expected") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::string pendulum = lesson_path("dynamics/simple-pendulum.toml");
    const std::string picture = folder.path("x.png");
    const std::vector<Case> cases{
        {{"simulate", pendulum, "--samples", "1e99"},
         "--samples '1e99'; expected a whole number, digits only"},
        {{"simulate", pendulum, "--samples", "99999999999999999999"},
         "--samples '99999999999999999999' is out of range; expected at most 2147483647"},
        {{"simulate", pendulum, "--samples", "010"},
         "--samples '010'; expected a whole number, digits only, no 0 before them"},
        {{"simulate", pendulum, "--samples", "0x10"},
         "--samples '0x10'; expected a whole number, digits only"},
        {{"simulate", pendulum, "--samples", ""}, "--samples ''; expected a whole number, digits only"},
        {{"simulate", pendulum, "--samples", "-5"}, "--samples is -5; expected 1 to 1000000"},
        {{"simulate", pendulum, "--tolerance", "1e-9999999"}, "--tolerance is out of range; expected"},
        {{"simulate", pendulum, "--tolerance", "tight"},
         "--tolerance 'tight'; expected a number such as 0.5 or 1e-6"},
        {{"simulate", pendulum, "--duration", "1e9999"}, "--duration is inf; expected a time above 0, in s"},
        {{"simulate", pendulum, "--method", "explicit5"},
         "--method 'explicit5'; expected one of euler, semi-implicit, rk4, explicit-5, explicit-8, "
         "implicit-5, "
         "implicit-9; did you mean 'explicit-5'?"},
        {{"step", crank, "--until", ""}, "--until ''; expected a whole number, digits only"},
        {{"step", crank, "--until", "1.5"}, "--until '1.5'; expected a whole number, digits only"},
        {{"step", crank, "--until", "99999999999999999999"}, "is out of range; expected at most 2147483647"},
        {{"step", crank, "--until", "1", "--until", "2"}, "--until is given 2 times; expected once"},
        {{"step", crank, "--untill", "1"}, "there is no option '--untill'; did you mean '--until'?"},
        {{"step", crank, "more"}, "'more' was not expected"},
        {{"step", crank, "--try"}, "--try has no value; expected TEXT"},
        {{"step", crank, "--format", "xml"}, "--format 'xml'; expected one of text, json"},
        {{"inspect", crank, "--time", ""}, "--time ''; expected a number such as 0.5 or 1e-6"},
        {{"inspect", crank, "--time", "1e400"}, "--time is not finite; expected a time in s"},
        {{"open", crank, "--text", "1e9", "--picture", picture},
         "--text 1e9 is out of range; expected 0.75 to 1.5"},
        {{"open", crank, "--text", "nan", "--picture", picture},
         "--text is not finite; expected 0.75 to 1.5"},
        {{"open", crank, "--at", "99999999999999999999", "--picture", picture},
         "--at '99999999999999999999'"},
        {{"open", crank, "--size", "1x1", "--picture", picture}, "--size '1x1'; expected"},
        {{"open", crank, "--size", "99999x99999", "--picture", picture}, "--size '99999x99999'; expected"},
        {{"render", crank, "--out", picture, "--fps", "1e9"},
         "--fps 1e9 is out of range; expected 0.1 to 240"},
        {{"render", crank, "--out", picture, "--fps", "ten"}, "--fps 'ten'; expected a number"},
        {{"render", crank, "--out", picture, "--frames", "5:2"}, "--frames '5:2'; expected A:B"},
        {{"render", crank, "--out", picture, "--frames", "99999999999999999999"}, "--frames '9999"},
        {{"solve", crank, "--from", "1e400"}, "--from, --to and --step must be finite numbers"},
        {{"solve", crank, "--step", "1e-400"}, "--step is not positive"},
        {{"plot", crank, "--out", picture, "--size", "99999x1"}, "--size '99999x1'; expected"},
        {{"--nosuch"}, "no command is given"},
    };
    for (const Case& c : cases) {
        std::string line;
        for (const std::string& argument : c.arguments) { line += " '" + argument + "'"; }
        CAPTURE(line);
        const Ran ran = run(c.arguments);
        CHECK(ran.status == 2);
        CHECK_THAT(ran.err, Catch::Contains(c.says));
        CHECK(ran.out.empty());
        check_words(ran);
    }
    CHECK_FALSE(std::filesystem::exists(picture));
}

TEST_CASE("No command line, however wrong, is answered with a name of a library, or with nothing") {
    constexpr std::uint32_t seed = 15;
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::string broken = folder.file("broken.toml", "format = 1\ntitle = 9999999999999999999999\n");
    const std::vector<std::string> commands{"list",  "check",    "step",  "inspect", "try",   "newton",
                                            "solve", "simulate", "bench", "plot",    "render"};
    const std::vector<std::string> options{
        "--until",   "--try",    "--format",     "--step",     "--time",      "--as-given", "--coordinates",
        "--at",      "--from",   "--to",         "--size",     "--frames",    "--fps",      "--out",
        "--of",      "--joint",  "--curves",     "--method",   "--tolerance", "--samples",  "--duration",
        "--picture", "--output", "--quiet",      "--analysis", "--compare",   "--text",     "--help-all",
        "-x",        "--",       "--motion-only"};
    const std::vector<std::string> values{
        "",
        "0",
        "-1",
        "1e99",
        "99999999999999999999",
        "nan",
        "inf",
        "0x7f",
        "text",
        "json",
        "csv",
        "x.png",
        "/",
        "/dev/full",
        "..",
        "5:2",
        ":",
        "960x540",
        "1x1",
        "rp",
        "methods",
        "pivot",
        "drive",
        "\x01\xff",
        "take out pivot",
        "length pivot 1e999",
        "drag crank by 1e400 0 0",
        "{}",
        "=",
        "=1",
        "quantities"};
    const auto any = [&](const std::vector<std::string>& list) { return list[random() % list.size()]; };
    for (int sample = 0; sample < 600; ++sample) {
        std::vector<std::string> arguments{any(commands)};
        if (random() % 8 != 0) { arguments.push_back(random() % 6 == 0 ? broken : crank); }
        for (auto k = random() % 4; k > 0; --k) {
            arguments.push_back(any(options));
            if (random() % 5 != 0) { arguments.push_back(any(values)); }
        }
        // correct command lines take long, and are tested elsewhere
        if (arguments[0] == "bench" || arguments[0] == "render") { arguments.emplace_back("--samples=x"); }
        // these folders would have all lessons of the machine
        if (arguments[0] == "check" || arguments[0] == "list") {
            std::erase_if(arguments, [](const std::string& a) { return a == "/" || a == ".."; });
        }
        std::string line;
        for (const std::string& argument : arguments) { line += " '" + argument + "'"; }
        CAPTURE(line);
        const Ran ran = run(arguments);
        CHECK((ran.status >= 0 && ran.status <= 3));
        check_words(ran);
    }
}

TEST_CASE("No lesson with wrong numbers is answered with a name of a library") {
    const Folder folder;
    const std::vector<std::string> numbers{
        "99999999999999999999",
        "-99999999999999999999",
        "1e999",
        "1e400",
        "-1e400",
        "1e-999",
        "nan",
        "inf",
        "-inf",
        "0x",
        "0xFFFFFFFFFFFFFFFFFF",
        "1__0",
        "1.",
        ".5",
        "1e",
        "+",
        "007",
        "1_000_000_000_000",
        "9223372036854775807",
        "9223372036854775808",
        "1979-05-27T07:32:00Z",
        "1979-99-99",
        "true",
        "\"1\"",
        "[1]",
        "{}",
        "1,5",
        "1 2",
        "--1",
        "\"\\uD800\"",
        "\"\\q\"",
        "'"};
    for (const std::string& number : numbers) {
        for (const char* key :
             {"to_s = 1", "steps = 4", "polynomial_deg = [0, 90]", "format = 1", "axis = [0, 0, 1]"}) {
            std::string text = kCrank;
            const std::string line = key;
            const std::string name = line.substr(0, line.find(" ="));
            const std::size_t at = text.find(line);
            REQUIRE(at != std::string::npos);
            text.replace(at, line.size(), name + " = " + number);
            CAPTURE(name, number);
            const Ran ran = run({"step", folder.file("number.toml", text), "--until", "0"});
            CHECK((ran.status == 0 || ran.status == 2));
            if (ran.status == 2) {
                CHECK(std::regex_search(ran.err, std::regex("number\\.toml:\\d+:\\d+: error: ")));
            }
            check_words(ran);
        }
    }
}

}  // namespace jw::test
