#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

#include "jointwise/analysis.hpp"
#include "jointwise/lesson.hpp"

namespace jointwise::test {
namespace {

using Catch::Contains;

Mechanism pair_of_bodies() {
    Mechanism m;
    m.add_body("one", {1.0, 0.0, 0.0});
    m.add_body("two", {2.0, 0.0, 0.0});
    m.add_joint("ball", "spherical", 1, 2, {});
    return m;
}

// Eigen's own vectors would accept two numbers, and then abort
template <class M>
concept TakesTwoNumbers = requires(M m) {
    m.add_body("a", {0.0, 0.0});
}
|| requires(M m) { m.add_body("a", {0, 0, 0}, {1, 0}); }
|| requires(M m) { m.set_gravity({0.0, -9.8}); }
|| requires(M m) { m.set_mass(1, 1.0, {1.0, 2.0}); }
|| requires(M m, Place place) { m.add_joint("a", "spherical", 0, 1, {.at = {0.0, 0.0}}); };
template <class M>
concept TakesThreeNumbers = requires(M m) {
    m.add_body("a", {0, 0.5, 0}, {1, 0, 0, 0});
    m.add_joint("a", "spherical", 0, 1, {.at = {0.0, 0.0, 1}});
};

}  // namespace

TEST_CASE("A vector of another size is no argument", "[api]") {
    static_assert(!TakesTwoNumbers<Mechanism> && TakesThreeNumbers<Mechanism>);
    Mechanism m = pair_of_bodies();
    CHECK_THROWS_WITH(m.add_body("a", Eigen::VectorXd::Zero(2)), Contains("2 numbers; expected 3"));
    CHECK_THROWS_WITH(m.set_mass(1, 1.0, Eigen::MatrixXd::Zero(2, 3)), Contains("6 numbers; expected 9"));
    CHECK(m.add_body("a", Eigen::VectorXd::Ones(3)) == 3);
}

TEST_CASE("A screw needs its pitch, as in a lesson", "[api]") {
    Mechanism m = pair_of_bodies();
    CHECK_THROWS_WITH(
        m.add_joint("x", "screw", 0, 1, {.axis = {0, 0, 1}}),
        Contains("pitch is absent; expected the advance in one turn [m]"));
    CHECK_THROWS_AS(m.add_joint("x", "screw", 0, 1, {}), std::invalid_argument);
    CHECK_NOTHROW(m.add_joint("x", "screw", 0, 1, {.pitch = -0.1}));
}

TEST_CASE("Arguments that make no sense are said and leave the mechanism as it was", "[api]") {
    Mechanism m = pair_of_bodies();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Place flat{.axis = Vector3::Zero()};
    const Place tilted{.axis = Vector3::UnitZ(), .axis2 = Vector3(0.0, 1.0, 1.0)};
    CHECK_THROWS_WITH(m.add_body("one", Vector3::Zero()), Contains("'one' is taken"));
    CHECK_THROWS_WITH(m.add_body("", Vector3::Zero()), Contains("a name is empty"));
    CHECK_THROWS_WITH(m.add_body("x", {nan, 0.0, 0.0}), Contains("not finite"));
    CHECK_THROWS_WITH(m.add_body("x", Vector3::Zero(), Vector4::Zero()), Contains("p of body 'x' is zero"));
    CHECK_THROWS_WITH(m.add_joint("x", "revolut", 0, 1, {}), Contains("no joint type 'revolut'"));
    CHECK_THROWS_WITH(m.add_joint("x", "revolute", 0, 3, {}), Contains("no body 3; the last is 2"));
    CHECK_THROWS_WITH(m.add_joint("x", "revolute", 1, 1, {}), Contains("with itself"));
    CHECK_THROWS_WITH(m.add_joint("x", "revolute", 0, 1, flat), Contains("axis is zero"));
    CHECK_THROWS_WITH(m.add_joint("x", "universal", 0, 1, {}), Contains("axis2 is absent"));
    CHECK_THROWS_WITH(m.add_joint("x", "universal", 0, 1, tilted), Contains("not perpendicular"));
    CHECK_THROWS_WITH(m.add_joint("x", "distance", 0, 1, {}), Contains("coincide"));
    CHECK_THROWS_WITH(m.add_joint("x", "formula", 0, 1, {}), Contains("which only lessons contain"));
    CHECK_THROWS_WITH(m.add_driver("x", 0, {1.0}), Contains("'ball' has no angle"));
    CHECK_THROWS_WITH(m.add_driver("x", 7, {1.0}), Contains("no joint 7"));
    CHECK_THROWS_WITH(m.set_mass(1, 0.0, Matrix3::Identity()), Contains("not positive"));
    CHECK(m.body_names() == std::vector<std::string>{"ground", "one", "two"});
    CHECK(m.joint_names() == std::vector<std::string>{"ball"});
    CHECK(m.driver_names().empty());
}

TEST_CASE("Poses, times and methods that make no sense are said", "[api]") {
    const Mechanism m = pair_of_bodies();
    CHECK_THROWS_WITH(rank_at(m, Pose{}), Contains("r of a pose has 0 entries; expected 3"));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Pose nowhere = start_pose(m);
    nowhere.r[1].x() = nan;
    Rates unknown = start_rates(m);
    unknown.omega_local[2].y() = nan;
    CHECK_THROWS_WITH(rank_at(m, nowhere), Contains("a number of a pose is not finite"));
    CHECK_THROWS_WITH(assemble(m, nan), Contains("the time is not finite"));
    CHECK_THROWS_WITH(equations_at(m, start_pose(m), unknown), Contains("velocities"));
    CHECK_THROWS_WITH(follow(m, {1.0, 0.0}), Contains("ascending"));
    CHECK_THROWS_WITH(follow(m, {}), Contains("no times"));
    CHECK_THROWS_WITH(
        simulate(m, {0.0}, {.method = "rk5"}), Contains("no method 'rk5'; expected one of euler"));
    CHECK_THROWS_AS(simulate(m, {0.0, 1.0}), std::invalid_argument);  // no masses
}

TEST_CASE("What cannot be assembled names the row that stays off", "[api]") {
    Mechanism m;
    const int body = m.add_body("rod", {1.0, 0.0, 0.0});
    m.add_joint("here", "spherical", 0, body, {.at = {0.0, 0.0, 0.0}});
    // another point of the ground, which this point of the body cannot reach
    m.add_joint("there", "spherical", 0, body, {.at = {3.0, 0.0, 0.0}, .to = Vector3(1.0, 0.0, 0.0)});
    CHECK_THROWS_AS(assemble(m), NotReached);
    CHECK_THROWS_WITH(assemble(m), Contains("cannot be assembled at t = 0") && Contains("here.s.x"));
}

TEST_CASE("Mistakes in a lesson are the report of the program", "[api]") {
    CHECK_THROWS_WITH(
        read_lesson_text("format = 1\ntitle = \"t\"\ncolor = 3\n", "my.toml"),
        Contains("my.toml:3:1: error: unknown key 'color'"));
}

TEST_CASE("Copies of a mechanism are independent", "[api]") {
    const Mechanism one = pair_of_bodies();
    Mechanism other = one;
    other.add_body("three", Vector3::Zero());
    CHECK(one.body_names().size() == 3);
    CHECK(other.body_names().size() == 4);
    other = one;
    CHECK(other.body_names().size() == 3);
}

}  // namespace jointwise::test
