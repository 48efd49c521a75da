#include <catch2/catch.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

/// Picture of the window as a PNG file.
std::string shown(const std::vector<std::string>& options) {
    const Folder folder;
    const std::string picture = folder.path("window.png");
    std::vector<std::string> arguments{"open"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.insert(arguments.end(), {"--picture", picture, "--size", "640x400"});
    const Ran ran = run(arguments);
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    return bytes_of(picture);
}

std::string refused(const std::string& address) {
    const Folder folder;
    const Ran ran = run({"open", address, "--picture", folder.path("window.png")});
    CHECK(ran.status == 2);
    CHECK(bytes_of(folder.path("window.png")).empty());
    return ran.err;
}

}  // namespace

TEST_CASE("open shows what an address says, as its options would", "[app][commands]") {
    const std::string lesson = lesson_path("loops/four-bar.toml");
    const std::string plots = shown({lesson, "--at", "D", "--tab", "plots"});
    CHECK(shown({"#four-bar/D?tab=plots"}) == plots);
    CHECK(shown({"https://example.org/jointwise/index.html#four-bar/D?tab=plots"}) == plots);
    CHECK(shown({"#loops/four-bar/", "--at", "D", "--tab", "plots"}) == plots);
    CHECK(shown({"#four-bar/D?try=take+out+D+p1+x"}) != shown({"#four-bar/D"}));
    CHECK(shown({"#four-bar/D?camera=3+-4+2.5+to+0+0+0"}) != shown({"#four-bar/D"}));
    CHECK(shown({"https://example.org/jointwise/"}) == shown({}));
}

TEST_CASE("open refuses an address that leads nowhere, with what was expected", "[app][commands]") {
    CHECK(
        refused("#four-bor/D") ==
        "jointwise: error: address '#four-bor/D': no lesson 'four-bor'\nhint: did you mean 'four-bar'?\n");
    CHECK(
        refused("#four-bar?try=form+E+rule")
            .find("'form E rule': no joint 'E'; expected one of A, B, C, D") != std::string::npos);
    CHECK(refused("#four-bar?tab=%").find("at character 15: '%' is not a character") != std::string::npos);
    CHECK(refused("#four-bar?tab=plot").find("no tab 'plot'") != std::string::npos);
}

TEST_CASE("open refuses an address with an exercise that its lesson does not have", "[app][commands]") {
    CHECK(
        refused("#four-bar?exercise=nope") ==
        "jointwise: error: address '#four-bar?exercise=nope': the lesson has no exercise 'nope'\n");
    const Folder folder;
    const std::string picture = folder.path("window.png");
    CHECK(run({"open", "#newton-raphson?exercise=rocker-angle", "--picture", picture}).status == 0);
    CHECK(std::filesystem::exists(picture));
}

TEST_CASE("A file that is called like an address is a file", "[app][commands]") {
    const Folder folder;
    const std::string odd = folder.file("#four-bar", bytes_of(lesson_path("loops/four-bar.toml")));
    CHECK(shown({odd, "--at", "D"}) == shown({"#four-bar/D"}));
}

}  // namespace jw::test
