#include <catch2/catch.hpp>

#include <cmath>

#include "jointwise/lesson.hpp"
#include "jointwise/measures.hpp"
#include "jointwise/statics.hpp"

namespace jointwise::test {
namespace {

constexpr double kG = 9.81;

/// A rod of 2 kg, its centre 0.5 m from a pin about y. @param lean  of the rod against the vertical [rad]
Mechanism pendulum(double lean) {
    Mechanism m;
    const int rod = m.add_body("rod", {0.5 * std::sin(lean), 0.0, 0.5 * std::cos(lean)});
    m.set_mass(rod, 2.0, 0.2 * Matrix3::Identity());
    m.set_gravity({0.0, 0.0, -kG});
    m.add_joint("pin", "revolute", 0, rod, {.at = {0.0, 0.0, 0.0}, .axis = {0.0, 1.0, 0.0}});
    return m;
}

}  // namespace

TEST_CASE("A pendulum rests below its pin, and swings about it with the period of the textbook", "[api]") {
    const Mechanism m = pendulum(1.5);
    const Equilibrium rest = find_equilibrium(m);
    CHECK(rest.freedoms == 1);
    CHECK(rest.stability == Stability::stable);
    CHECK((rest.moment.pose.r[1] - Vector3(0.0, 0.0, -0.5)).norm() < 1e-9);
    CHECK(rest.moment.energy == Approx(-2.0 * kG * 0.5).epsilon(1e-9));
    REQUIRE(rest.small_motions.size() == 1);
    const SmallMotion& swing = rest.small_motions.front();
    CHECK(std::abs(swing.s.real()) < 1e-6);
    CHECK(swing.s.imag() == Approx(std::sqrt(2.0 * kG * 0.5 / (0.2 + 2.0 * 0.25))).epsilon(1e-8));
    // a turn of 1 rad about y moves the centre by half a metre along x
    CHECK(std::abs(swing.shape.r_dot[1].x()) == Approx(0.5 * std::abs(swing.shape.omega_local[1].y())));
    const Reactions found = reactions_at(m, rest.moment);
    REQUIRE(found.reactions.size() == 1);
    CHECK((found.reactions[0].force - Vector3(0.0, 0.0, 2.0 * kG)).norm() < 1e-8);
}

TEST_CASE("A body whose frame is at its pin only turns in a small motion", "[api]") {
    Mechanism m;
    const int rod = m.add_body("rod", {0.0, 0.0, 0.0});
    m.set_mass(rod, 2.0, 0.2 * Matrix3::Identity(), {0.3, 0.0, 0.4});
    m.set_gravity({0.0, 0.0, -kG});
    m.add_joint("pin", "revolute", 0, rod, {.at = {0.0, 0.0, 0.0}, .axis = {0.0, 1.0, 0.0}});
    const Equilibrium rest = find_equilibrium(m);
    REQUIRE(rest.small_motions.size() == 1);
    const SmallMotion& swing = rest.small_motions.front();
    CHECK(rest.moment.pose.r[1].norm() < 1e-12);
    CHECK(swing.shape.r_dot[1].norm() < 1e-12);
    CHECK(std::abs(swing.shape.omega_local[1].y()) > 0.1);
    CHECK(swing.s.imag() == Approx(std::sqrt(2.0 * kG * 0.5 / (0.2 + 2.0 * 0.25))).epsilon(1e-8));
    CHECK(rest.moment.energy == Approx(-2.0 * kG * 0.5).epsilon(1e-9));
}

TEST_CASE("From just above, the nearest equilibrium of a pendulum is upright and unstable", "[api]") {
    const Equilibrium upright = find_equilibrium(pendulum(0.1), Seek::nearest);
    CHECK((upright.moment.pose.r[1] - Vector3(0.0, 0.0, 0.5)).norm() < 1e-9);
    CHECK(upright.stability == Stability::unstable);
    CHECK(upright.small_motions.front().s.real() > 0.0);
}

TEST_CASE("What falls for ever has no equilibrium", "[api]") {
    Mechanism m;
    m.set_mass(m.add_body("stone", {0.0, 0.0, 0.0}), 1.0, Matrix3::Identity());
    m.set_gravity({0.0, 0.0, -kG});
    CHECK_THROWS_WITH(find_equilibrium(m), Catch::Contains("nothing resists them"));
}

TEST_CASE("A lesson rests where its claims say", "[api]") {
    const Lesson lesson =
        read_lesson(std::string(JW_SOURCE_ROOT) + "/lessons/catalogue/statics/rubber-hinge.toml");
    const Equilibrium rest = find_equilibrium(lesson.mechanism());
    CHECK(rest.freedoms == 3);
    CHECK(rest.moment.pose.r[1].z() == Approx(0.991294879047495).epsilon(1e-9));
    CHECK(rest.stability == Stability::stable);
}

}  // namespace jointwise::test
