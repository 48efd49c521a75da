#include <catch2/catch.hpp>

#include <numbers>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

using Json = nlohmann::json;

const std::string kPendulum = lesson_path("dynamics/simple-pendulum.toml");

Json rest_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "rest");
    arguments.insert(arguments.end(), {"--format", "json"});
    const Ran ran = run(arguments);
    INFO(ran.err);
    CHECK(ran.status == 0);
    return Json::parse(ran.out);
}

Json named(const Json& list, const std::string& name) {
    for (const Json& entry : list) {
        if (entry["name"] == name) { return entry; }
    }
    return {};
}

/// A bead on a rail without an end.
constexpr const char* kFalling = R"(format = 1
title = "Falls"
[dynamics]
duration = 1
gravity = [0, 0, -9.81]
[[body]]
name = "stone"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "rail"
type = "prismatic"
bodies = ["ground", "stone"]
at = [0, 0, 0]
axis = [0, 0, 1]
)";

}  // namespace

TEST_CASE("rest tells where a pendulum hangs, what holds it, and how it swings", "[app][rest]") {
    const Json rest = rest_of({kPendulum});
    CHECK(rest["stability"] == "stable");
    CHECK(rest["conservative"] == true);
    CHECK(rest["failure"].is_null());
    // a point mass of 1 kg at 1 m, with the inertia that the lesson gives it
    CHECK(named(rest["quantities"], "pin.angle")["value"].get<double>() == Approx(0.5 * std::numbers::pi));
    CHECK(named(rest["reactions"], "pin")["force"][1].get<double>() == Approx(9.81));
    CHECK(rest["modes"][0]["frequency_hz"].get<double>() == Approx(0.498239).epsilon(1e-5));
    CHECK(named(rest["modes"][0]["joints"], "pin.angle")["amplitude"][0] == 1.0);
    CHECK_THAT(run({"rest", kPendulum}).out, Catch::Contains("Stable: the potential energy"));
}

TEST_CASE("rest tells which torque holds a joint where it starts", "[app][rest]") {
    const Json held = rest_of({kPendulum, "--hold", "pin"});
    CHECK(held["freedoms"] == 0);
    CHECK(
        std::abs(named(held["quantities"], "hold pin.angle.effort")["value"].get<double>()) == Approx(9.81));
    const Ran slip = run({"rest", kPendulum, "--hold", "pim"});
    CHECK(slip.status == 2);
    CHECK_THAT(slip.err, Catch::Contains("--hold 'pim'") && Catch::Contains("expected one of pin.angle"));
}

TEST_CASE("rest holds each joint once, and knows what was taken out", "[app][rest]") {
    for (const std::string& again : {std::string("pin"), std::string("pin.angle")}) {
        const Ran twice = run({"rest", kPendulum, "--hold", "pin", "--hold", again});
        CHECK(twice.status == 2);
        CHECK_THAT(twice.err, Catch::Contains("'hold pin.angle' prescribes it already"));
    }
    const Ran falls = run({"rest", kPendulum, "--try", "take out pin"});
    CHECK(falls.status == 3);
    CHECK_THAT(falls.err, Catch::Contains("'ball' would be accelerated by 9.81 m/s² and 0 rad/s²"));
}

TEST_CASE("rest finds an unstable equilibrium only where it is asked for, or starts there", "[app][rest]") {
    CHECK(rest_of({kPendulum, "--nearest"})["failure"].is_null());
    const std::string loop = lesson_path("dynamics/four-bar-1.toml");
    CHECK(rest_of({loop})["stability"] == "unstable");
    CHECK_THAT(run({"rest", loop}).out, Catch::Contains("It starts exactly there"));
}

TEST_CASE("rest says what still moves where there is no equilibrium, and what is missing", "[app][rest]") {
    const Folder folder;
    const Ran falls = run({"rest", folder.file("falls.toml", kFalling)});
    INFO(falls.err);
    CHECK(falls.status == 3);
    CHECK(falls.out.empty());
    CHECK_THAT(falls.err, Catch::Contains("'stone' would be accelerated by 9.81 m/s²"));
    const Ran kinematics = run({"rest", folder.file("crank.toml", kCrank)});
    CHECK(kinematics.status == 2);
    CHECK_THAT(kinematics.err, Catch::Contains("no [dynamics]"));
}

}  // namespace jw::test
