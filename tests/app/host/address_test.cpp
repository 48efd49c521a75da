#include "app/host/lesson/address.hpp"

#include <catch2/catch.hpp>

#include <numbers>

#include "tests/support/mutated_text.hpp"
#include "tests/support/random_mechanisms.hpp"

namespace jw::test {
namespace {

using host::Address;
using host::fragment_of;
using host::read_address;

Address four_bar(std::string at = {}) {
    Address address;
    address.lesson = "four-bar";
    address.at = std::move(at);
    return address;
}

std::string problem_of(const std::string& text) {
    try {
        read_address(text);
    } catch (const std::runtime_error& problem) { return problem.what(); }
    return {};
}

/// Addresses that together have every part, with characters that need care.
std::vector<Address> different_addresses() {
    std::vector<Address> all{Address{}, four_bar(), four_bar("12"), four_bar("t=0.5"), four_bar("my pin/2")};
    all.push_back(four_bar("D"));
    all.back().experiments = {"form D drop x", "take out \"the motor\"", "place 桿 at 0.1 -3e-7 1e9"};
    all.back().tab = "plots";
    all.back().joint = "A & B = C";
    all.back().exercise = "local-vector";
    all.back().camera =
        render::Camera{{0.1, 1.0 / 3.0, -2e-5}, {1e-300, 0.0, 7.0}, {0.6, 0.8, 0.0}, 0.1, true};
    for (const char* name : {"loops/four-bar", "a/b/c", "mine.toml", "50% + 1?.toml", "#:é~", "x=y&z"}) {
        all.push_back(four_bar());
        all.back().lesson = name;
        all.push_back(all.back());
        all.back().at = "3";
    }
    return all;
}

}  // namespace

TEST_CASE("An address is as short as what it says", "[address]") {
    CHECK(fragment_of({}).empty());
    CHECK(fragment_of(four_bar()) == "four-bar");
    CHECK(fragment_of(four_bar("12")) == "four-bar/12");
    Address address = four_bar("D");
    address.experiments = {"form D drop x", "axis A i 0 1 0"};
    address.joint = "A";
    address.tab = "plots";
    CHECK(fragment_of(address) == "four-bar/D?try=form+D+drop+x&try=axis+A+i+0+1+0&joint=A&tab=plots");
    address = four_bar();
    address.camera = render::Camera{{3.0, -4.0, 2.5}, {0.0, 0.0, 0.5}};
    CHECK(fragment_of(address) == "four-bar?camera=3+-4+2.5+to+0+0+0.5");
    address.camera->up = {0.0, 1.0, 0.0};
    address.camera->field_of_view = 0.25;
    address.camera->orthographic = true;
    CHECK(fragment_of(address) == "four-bar?camera=3+-4+2.5+to+0+0+0.5+up+0+1+0+angle+0.25+parallel");
    address = four_bar();
    address.exercise = "local-vector";
    CHECK(fragment_of(address) == "four-bar?exercise=local-vector");
    // a folder needs the slash behind it, which says that no place follows
    address = Address{};
    address.lesson = "loops/four-bar";
    CHECK(fragment_of(address) == "loops/four-bar/");
    address.at = "a/b c";
    CHECK(fragment_of(address) == "loops/four-bar/a%2Fb%20c");
}

TEST_CASE("An address is read as it was written, alone, behind a # and in a URL", "[address]") {
    for (const Address& address : different_addresses()) {
        const std::string text = fragment_of(address);
        INFO(text);
        CHECK(read_address(text) == address);
        CHECK(read_address("#" + text) == address);
        CHECK(read_address("https://example.org/jointwise/?a=b#" + text) == address);
        CHECK(read_address("file:///lectures/my%20course/index.html#" + text) == address);
    }
}

TEST_CASE("An address that somebody typed is read as it is meant", "[address]") {
    const Address typed = read_address("#four-bar/D?try=form D drop x&&tab=plots&");
    CHECK(typed.experiments == std::vector<std::string>{"form D drop x"});
    CHECK(typed.tab == "plots");
    CHECK(read_address("#four%2dbar/D").lesson == "four-bar");
    CHECK(read_address("#mine+yours.toml").lesson == "mine+yours.toml");
    CHECK(read_address("https://example.org/jointwise/?x=1") == Address{});
    CHECK(read_address("#") == Address{});
    CHECK(read_address("#桿/D").lesson == "桿");
}

TEST_CASE("An address that cannot be read says what is wrong, where, and what was expected", "[address]") {
    struct Case {
        std::string text;
        std::string says;
    };
    const std::vector<Case> cases{
        {"#four-bar?try=form+%zz",
         "at character 20: '%zz' is not a character; expected % and two hexadecimal"},
        {"#four-bar?try=%4", "at character 15: '%4' is not a character"},
        {"#four-bar?try=%FF", "at character 15: what begins here is not UTF-8"},
        {"#桿%41?foo=1", "at character 7: no part 'foo'; expected one of try, joint, tab, exercise, camera"},
        {"#four-bar?tab", "at character 11: 'tab' is empty; expected a value after ="},
        {"#four-bar?try=", "'try' is empty"},
        {"#four-bar?tab=try&tab=step", "at character 19: a second tab; expected one"},
        {"#four-bar?joint=A&joint=B", "a second joint; expected one"},
        {"#/D", "at character 2: no lesson is named; expected the name of a lesson first"},
        {"?tab=plots", "at character 1: no lesson is named"},
        {"#a?camera=1+2+3", "camera '1 2 3': expected 'to' and what the eye looks at"},
        {"#a?camera=1+2+to+0+0+0", "'to' where a coordinate of the eye [m] should be; expected a number"},
        {"#a?camera=1+2+3+to+1+2+3",
         "the camera cannot see anything from there; expected an eye that is not"},
        {"#a?camera=0+0+3+to+0+0+0", "an 'up' that is not along the view"},
        {"#a?camera=3+0+0+to+0+0+0+angle+4", "an angle of view above 0 and below 3.1 rad"},
        {"#a?camera=1e99+0+0+to+0+0+0", "expected at most 1e9 in magnitude"},
        {"#a?camera=3+0+0+to+0+0+0+sideways", "'sideways' is left over"},
        {"#a?camera=3+0+0+to+0+0+0&camera=1", "a second camera; expected one"},
        {"#" + std::string(2U << 20U, 'a'), "the address is too long; expected at most 1048576 bytes"},
    };
    for (const Case& c : cases) {
        INFO(c.text.substr(0, 80) << " -> " << problem_of(c.text));
        CHECK(problem_of(c.text).find(c.says) != std::string::npos);
    }
    std::string many = "#a?try=x";
    for (int k = 0; k < 1000; ++k) { many += "&try=x"; }
    CHECK(problem_of(many).find("one experiment too many; expected at most 1000") != std::string::npos);
}

TEST_CASE("A camera is told exactly", "[address]") {
    Random random(3);
    int told = 0;
    for (int k = 0; k < 2000; ++k) {
        Address address = four_bar();
        render::Camera camera;
        camera.eye = random.vector(std::pow(10.0, random.number(-6.0, 8.0)));
        camera.target = random.vector(std::pow(10.0, random.number(-6.0, 8.0)));
        camera.up = random.direction();
        camera.field_of_view = random.number(0.01, 3.0);
        camera.orthographic = k % 2 == 0;
        address.camera = camera;
        if (!host::can_be_told(camera)) { continue; }
        ++told;
        CHECK(read_address(fragment_of(address)) == address);
    }
    CHECK(told > 1900);
}

TEST_CASE("A camera that sees nothing is not told", "[address]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    using render::Camera;
    for (const Camera& camera :
         {Camera{{nan, 0.0, 0.0}}, Camera{{1e10, 0.0, 0.0}}, Camera{{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},
          Camera{{0.0, 0.0, 2.0}}, Camera{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
          Camera{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, std::numbers::pi}}) {
        CHECK_FALSE(host::can_be_told(camera));
        Address address = four_bar();
        address.camera = camera;
        CHECK_THROWS_AS(fragment_of(address), std::invalid_argument);
    }
    Address nowhere;
    nowhere.tab = "plots";
    CHECK_THROWS_AS(fragment_of(nowhere), std::invalid_argument);
}

TEST_CASE("Whatever is read of 100000 damaged addresses is written and read the same again", "[address]") {
    std::vector<std::string> kept;
    for (const Address& address : different_addresses()) { kept.push_back("#" + fragment_of(address)); }
    kept.push_back("https://example.org/a?b#" + kept[5].substr(1));
    const std::vector<std::string> words{
        "%",  "%4",  "%25", "%2F", "/",      "?",   "&", "=",  "+",   "camera=", "try=", "tab=",  "to",
        "up", "1e9", "-0",  "nan", "1e-400", "://", "#", "\"", "%00", "%C3",     "%A9",  "angle", "parallel"};
    std::mt19937 random(20261126);
    int read = 0;
    for (int k = 0; k < 100000; ++k) {
        const std::string text = mutated(kept[random() % kept.size()], random, words);
        Address address;
        try {
            address = read_address(text);
        } catch (const std::runtime_error& problem) {
            if (std::string(problem.what()).starts_with("at character ")) { continue; }
            FAIL_CHECK(text << " -> " << problem.what());
        }
        ++read;
        const std::string again = fragment_of(address);
        if (read_address(again) != address) { FAIL_CHECK(text << " -> " << again); }
        if (fragment_of(read_address(again)) != again) { FAIL_CHECK(text << " -> " << again); }
    }
    // if most addresses were refused, hardly anything would be checked
    CHECK(read > 10000);
}

}  // namespace jw::test
