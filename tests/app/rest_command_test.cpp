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

/// A point mass of 1 kg at 1 m, level at the start; its angle counts upwards.
constexpr const char* kArm = R"(format = 1
title = "Arm"
[dynamics]
duration = 1
gravity = [0, 0, -9.81]
[[body]]
name = "arm"
position = [1, 0, 0]
mass = 1
inertia = [0.01, 0.01, 0.01]
[[joint]]
name = "pin"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, -1, 0]
)";

}  // namespace

TEST_CASE("rest tells where a pendulum hangs, its reactions, and how it swings", "[app][rest]") {
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
    // 0.15 / (2 sqrt(0.12 · 2.943)), see tests/app/host/rest_tab_test.cpp
    CHECK_THAT(run({"rest", lesson_path("statics/lamp.toml")}).out, Catch::Contains("damping ratio 0.1262"));
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
    CHECK_THAT(run({"rest", loop}).out, Catch::Contains("The mechanism starts exactly there"));
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

TEST_CASE("Claims at rest are judged at the equilibrium, with its reactions", "[app][rest]") {
    const Folder folder;
    const auto checked = [&](const std::string& lesson, const std::string& claim,
                             const std::string& experiment) {
        std::vector<std::string> arguments{
            "check", folder.file("claim.toml", lesson + "\n[[expect]]\nat_rest = true\n" + claim)};
        if (!experiment.empty()) { arguments.insert(arguments.end(), {"--try", experiment}); }
        return run(arguments);
    };
    const std::string free = kArm;
    CHECK(checked(free, "stable = true\n", "").status == 0);
    CHECK(checked(free, "stable = false\n", "").status == 1);
    CHECK(checked(free, "quantity = \"pin.angle\"\nvalue_deg = -90\ntolerance_deg = 1e-6\n", "").status == 0);
    CHECK(checked(free, "quantity = \"pin.force.z\"\nvalue = 9.81\ntolerance = 1e-9\n", "").status == 0);
    CHECK(checked(free, "quantity = \"pin.force.z\"\nvalue = 9.82\ntolerance = 1e-9\n", "").status == 1);
    CHECK(checked(free, "rank = 5\ndof = 1\nresidual_below = 1e-12\n", "").status == 0);

    // a motor holds the rod level, also if a driver before it is taken out
    const auto motor = [](const std::string& name, const std::string& deg) {
        return "\n[[driver]]\nname = \"" + name +
               "\"\njoint = \"pin\"\nquantity = \"angle\"\npolynomial_deg = [" + deg + "]\n";
    };
    const std::string effort = "quantity = \"motor.effort\"\nvalue = 9.81\ntolerance = 1e-9\n";
    CHECK(checked(free + motor("motor", "0"), effort, "").status == 0);
    CHECK(checked(free + motor("other", "0") + motor("motor", "0"), effort, "take out other").status == 0);
    // without the motor it hangs
    const std::string hangs = "quantity = \"pin.angle\"\nvalue_deg = -90\ntolerance_deg = 1e-6\n";
    CHECK(checked(free + motor("motor", "0"), hangs, "").status == 1);
    CHECK(checked(free + motor("motor", "0"), hangs, "take out motor").status == 0);

    const Ran falls = checked(kFalling, "stable = true\n", "");
    CHECK(falls.status == 1);
    CHECK_THAT(falls.err + falls.out, Catch::Contains("nothing resists them"));
}

TEST_CASE("At rest drivers stand as at t = 0, and angles are those of the pose", "[app][rest]") {
    const Folder folder;
    const auto holds = [&](const std::string& lesson, const std::string& claim) {
        return run({"check", folder.file("claim.toml", lesson + "\n[[expect]]\nat_rest = true\n" + claim)})
                   .status == 0;
    };
    const auto driven = [](const std::string& deg) {
        return std::string(kArm) +
               "\n[[driver]]\nname = \"motor\"\njoint = \"pin\"\nquantity = \"angle\"\npolynomial_deg = [" +
               deg + "]\n";
    };
    const auto angle = [](const std::string& deg) {
        return "quantity = \"pin.angle\"\nvalue_deg = " + deg + "\ntolerance_deg = 1e-9\n";
    };
    CHECK(holds(driven("20, 30") + "[motion]\nfrom_s = 1\nto_s = 2\n", angle("20")));
    CHECK(holds(driven("800"), angle("80")));
    CHECK(holds(driven("800"), angle("800")));
    CHECK_FALSE(holds(driven("800"), angle("81")));
}

TEST_CASE("Where a spring carries the whole weight, reactions are zero and not missing", "[app][rest]") {
    const Folder folder;
    const std::string lesson = std::string(kFalling) + "\n[[spring]]\njoint = \"rail\"\nstiffness = 100\n";
    const std::string claims =
        "[[expect]]\nat_rest = true\nquantity = \"rail.displacement\"\nvalue = -0.0981\ntolerance = 1e-12\n"
        "[[expect]]\nat_rest = true\nquantity = \"rail.force.x\"\nvalue = 0\ntolerance = 1e-9\n";
    const Ran ran = run({"check", folder.file("scale.toml", lesson + claims)});
    INFO(ran.out);
    CHECK(ran.status == 0);
}

}  // namespace jw::test
