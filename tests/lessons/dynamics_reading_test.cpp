#include <catch2/catch.hpp>

#include <cmath>

#include "core/jets/euler_parameters.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;
using test::is_near;
using test::kRounding;
using test::lesson_of;

namespace {

/// A body turned by a quarter about z, its origin at (1, 2, 3), on a hinge at the ground's origin.
Lesson arm_with(const std::string& loads, const std::string& mass = "mass = 1\ninertia = [1, 2, 3]\n") {
    return lesson_of(
        "format = 1\ntitle = \"t\"\n[[body]]\nname = \"arm\"\nposition = [1, 2, 3]\n"
        "rotation = { axis = [0, 0, 1], angle_deg = 90 }\n" +
        mass +
        "[[joint]]\nname = \"hinge\"\ntype = \"revolute\"\nbodies = [\"ground\", \"arm\"]\nat = [0, 0, 0]\n"
        "axis = [0, 0, 1]\nside_i = [1, 0, 0]\nside_j = [1, 0, 0]\n[dynamics]\nduration = 2\n" +
        loads);
}

MassProperties mass_with(const std::string& keys) {
    const Lesson lesson = arm_with("", keys);
    REQUIRE(lesson.dynamics->loads.masses.size() == 2);
    REQUIRE(lesson.dynamics->loads.masses[1].has_value());
    CHECK(!lesson.dynamics->loads.masses[0].has_value());
    return *lesson.dynamics->loads.masses[1];
}

}  // namespace

TEST_CASE("A lesson without [dynamics] has none, whatever else it says", "[lessons][dynamics]") {
    CHECK(!lesson_of(test::documented_lesson()).dynamics.has_value());
}

TEST_CASE(
    "The door of the documentation reads as it is described, without a warning", "[lessons][dynamics]") {
    const ReadResult result = read_lesson(test::documented_toml()[3], "door.toml");
    CHECK(result.report() == "");
    REQUIRE(result.lesson.has_value());
    const DynamicsPlan& plan = *result.lesson->dynamics;
    CHECK(plan.loads.masses[1]->J_local(2, 2) == 1.071);
    CHECK(is_near(plan.point->point_local, Vec3(0.4, 0, 0)));
    CHECK(plan.loads.rotational_springs[0].free_angle == 0.0);
    // 2 N + 1 N sin(2π t/2)
    CHECK(plan.loads.forces[0].magnitude.at(0.5).f == Approx(3.0).margin(kRounding));
    CHECK(plan.loads.forces[0].direction == Vec3(0, -1, 0));
}

TEST_CASE("An inertia tensor is the same in all three ways to write it", "[lessons][dynamics]") {
    const MassProperties plain = mass_with("mass = 2\ninertia = [1, 2, 2.5]\n");
    CHECK(plain.mass == 2.0);
    CHECK(plain.centre_local == Vec3::Zero());
    CHECK(plain.J_local == Mat3(Vec3(1, 2, 2.5).asDiagonal()));
    const MassProperties six =
        mass_with("mass = 2\ncentre = [0, 1, 0]\ninertia = [1, 2, 2.5, 0.1, -0.2, 0.3]\n");
    const MassProperties rows =
        mass_with("mass = 2\ninertia = [[1, 0.1, -0.2], [0.1, 2, 0.3], [-0.2, 0.3, 2.5]]\n");
    CHECK(six.centre_local == Vec3(0, 1, 0));
    CHECK(six.J_local(1, 2) == 0.3);
    CHECK(six.J_local == rows.J_local);
    // a thin plate and a slender rod, as typed with four digits
    CHECK(mass_with("mass = 1\ninertia = [0.08333, 0.08333, 0.1667]\n").mass == 1.0);
    CHECK(mass_with("mass = 1\ninertia = [1e-6, 0.08333, 0.08333]\n").mass == 1.0);
}

TEST_CASE("A lesson of dynamics has its plan, and defaults for what it does not say", "[lessons][dynamics]") {
    const DynamicsPlan usual = *arm_with("").dynamics;
    CHECK(usual.duration == 2.0);
    CHECK(usual.loads.gravity == Vec3::Zero());
    CHECK(usual.settings.method == Method::explicit_8);
    CHECK(usual.settings.treatment == Treatment::projection);
    CHECK(!usual.point.has_value());
    const DynamicsPlan plan = *arm_with(R"(gravity = [0, -9.81, 0]
method = "semi-implicit"
treatment = "none"
tolerance = 1e-9
step = 0.25
point = { body = "arm", at = [1, 3, 3] }
point_at_end = [7, 8, 9]
)")
                                   .dynamics;
    CHECK(plan.loads.gravity == Vec3(0, -9.81, 0));
    CHECK(plan.settings.method == Method::semi_implicit);
    CHECK(plan.settings.treatment == Treatment::none);
    CHECK(plan.settings.tolerance == 1e-9);
    CHECK(plan.settings.step == 0.25);
    REQUIRE(plan.point.has_value());
    CHECK(plan.point->body == 1);
    CHECK(is_near(plan.point->point_local, Vec3(1, 0, 0)));
    CHECK(plan.point_at_end == Vec3(7, 8, 9));
    const DynamicsPlan local = *arm_with("point = { body = \"arm\", point = [4, 5, 6] }\n").dynamics;
    CHECK(local.point->point_local == Vec3(4, 5, 6));
}

TEST_CASE("Every name of a method and a treatment can be typed", "[lessons][dynamics]") {
    for (const MethodName& name : kMethods) {
        const std::string key = "method = \"" + std::string(name.name) + "\"\n";
        CHECK(arm_with(key).dynamics->settings.method == name.method);
    }
    for (const TreatmentName& name : kTreatments) {
        const std::string key = "treatment = \"" + std::string(name.name) + "\"\n";
        CHECK(arm_with(key).dynamics->settings.treatment == name.treatment);
    }
}

TEST_CASE("A force acts where and as it is typed", "[lessons][dynamics]") {
    const Loads loads = arm_with(
                            R"([[force]]
body = "arm"
at = [1, 3, 3]
force = [0, 0, 5]
[[force]]
body = "arm"
direction = [0, 3, 4]
polynomial = [10, 2]
frame = "local"
[[force]]
body = "arm"
point = [7, 8, 9]
force = [0, 0, 5]
polynomial = [10, 2]
[[torque]]
body = "arm"
torque = [0, 0, 5]
frame = "local"
)",
                            "mass = 1\ninertia = [1, 2, 3]\ncentre = [0, 0, 0.5]\n")
                            .dynamics->loads;
    REQUIRE(loads.forces.size() == 3);
    const AppliedForce& constant = loads.forces[0];
    CHECK(constant.body == 1);
    CHECK(is_near(constant.point_local, Vec3(1, 0, 0)));
    CHECK(constant.direction == Vec3(0, 0, 5));
    CHECK(constant.frame == Frame::global);
    CHECK(constant.magnitude.at(1.5).f == 1.0);
    // given a direction, the function is in N: 10 N + 2 N/s t along a unit vector, at the centre of mass
    const AppliedForce& growing = loads.forces[1];
    CHECK(growing.point_local == Vec3(0, 0, 0.5));
    CHECK(is_near(growing.direction, Vec3(0, 0.6, 0.8)));
    CHECK(growing.frame == Frame::local);
    CHECK(growing.magnitude.at(1.0).f == 12.0);
    // given the force itself, the function is a factor
    CHECK(loads.forces[2].direction == Vec3(0, 0, 5));
    CHECK(loads.forces[2].magnitude.at(1.0).f == 12.0);
    REQUIRE(loads.torques.size() == 1);
    CHECK(loads.torques[0].direction == Vec3(0, 0, 5));
    CHECK(loads.torques[0].frame == Frame::local);
    CHECK(loads.torques[0].magnitude.at(1.5).f == 1.0);
}

TEST_CASE(
    "A load said in two ways, or a tolerance of no use, is one mistake and not two", "[lessons][dynamics]") {
    const std::string head =
        "format = 1\ntitle = \"t\"\n[[body]]\nname = \"b\"\nmass = 1\ninertia = [1, 1, 1]\n";
    const auto errors = [&](const std::string& rest) {
        const ReadResult read = read_lesson(head + rest, "lesson.toml");
        REQUIRE_FALSE(read.lesson);
        return read.report();
    };
    const std::string both =
        errors("[dynamics]\n[[force]]\nbody = \"b\"\nforce = [1, 0, 0]\ndirection = [0, 1, 0]\n");
    CHECK(both.find("direction") != std::string::npos);
    CHECK(both.find("polynomial") == std::string::npos);
    for (const char* tolerance : {"1e-20", "10"}) {
        const std::string range = errors("[dynamics]\ntolerance = " + std::string(tolerance) + "\n");
        CHECK(range.find("lesson.toml:8:13: error: a tolerance of") != std::string::npos);
        CHECK(range.find("expected 1e-15 to 0.1") != std::string::npos);
    }
}

TEST_CASE("Springs are free at the start unless told otherwise", "[lessons][dynamics]") {
    const Loads loads = arm_with(R"([[spring]]
bodies = ["ground", "arm"]
at = [1, 2, 0]
to = [1, 2, 3]
stiffness = 10
[[spring]]
bodies = ["arm", "ground"]
point_i = [1, 0, 0]
point_j = [4, 5, 6]
stiffness = 10
free_length = 0.5
damping = 2
[[rotational_spring]]
joint = "hinge"
stiffness = 3
[[rotational_spring]]
joint = "hinge"
damping = 4
free_angle_deg = 180
)")
                            .dynamics->loads;
    REQUIRE(loads.springs.size() == 2);
    CHECK(loads.springs[0].body_i == 0);
    CHECK(is_near(loads.springs[0].P_j_local, Vec3::Zero()));
    CHECK(loads.springs[0].free_length == Approx(3.0).margin(kRounding));
    CHECK(loads.springs[0].damping == 0.0);
    CHECK(loads.springs[1].P_i_local == Vec3(1, 0, 0));
    CHECK(loads.springs[1].P_j_local == Vec3(4, 5, 6));
    CHECK(loads.springs[1].free_length == 0.5);
    CHECK(loads.springs[1].damping == 2.0);
    REQUIRE(loads.rotational_springs.size() == 2);
    // the arm starts a quarter of a turn from the ground's x
    CHECK(loads.rotational_springs[0].free_angle == Approx(std::acos(0.0)).margin(kRounding));
    CHECK(loads.rotational_springs[0].stiffness == 3.0);
    CHECK(loads.rotational_springs[1].free_angle == Approx(2.0 * std::acos(0.0)).margin(kRounding));
    CHECK(loads.rotational_springs[1].damping == 4.0);
}

TEST_CASE("A free body with a mass is a lesson of dynamics, without a warning", "[lessons][dynamics]") {
    const ReadResult result = read_lesson(
        "format = 1\ntitle = \"t\"\n[[body]]\nname = \"b\"\nmass = 1\ninertia = [1, 2, 3]\n[dynamics]\n"
        "duration = 1\n[[step]]\nat_s = 0.5\ntext = \"half the time\"\n",
        "test.toml");
    CHECK(result.report() == "");
    REQUIRE(result.lesson.has_value());
    CHECK(!result.lesson->motion.has_value());
    CHECK(result.lesson->step_texts.times.size() == 1);
}
