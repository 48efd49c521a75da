#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/scenes.hpp"

/// Gears, bevel gears and racks against the ratios of the books, with rotations of their own.
using namespace jw;
using test::kPi;

namespace {

/// Largest difference of a body from its start pose turned by `angle` about an axis through the origin.
double off(const Mechanism& mechanism, const State& state, int body, const Vec3& axis, double angle) {
    const Eigen::AngleAxisd turn(angle, axis.normalized());
    const auto b = static_cast<std::size_t>(body);
    const Body& start = mechanism.bodies[b];
    const Mat3 expected = turn.toRotationMatrix() * rotation_matrix(start.p);
    return (rotation_matrix(state.p[b]) - expected).cwiseAbs().maxCoeff() +
           (state.r[b] - turn * start.r).cwiseAbs().maxCoeff();
}

/// A number of teeth over another, which decimals do not say exactly.
double random_ratio(test::Random& random) {
    const auto teeth = [&] { return std::floor(random.number(8.0, 40.0)); };
    const double a = teeth();
    return a / teeth();
}

}  // namespace

TEST_CASE(
    "A planetary gear turns as Willis's equation says, over many turns of any ratio", "[core][wheels]") {
    for (unsigned seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const double outer = -random_ratio(random);
        double inner = random_ratio(random);
        // a product of 1 would keep the sun at rest, whatever the carrier does
        if (std::abs(outer * inner - 1.0) < 0.05) { inner *= 0.7; }
        const Vec3 axis = random.direction();
        Mechanism mechanism = test::planetary_gear(outer, inner, axis);
        const double rate = random.number(-8.0, 8.0);
        test::drive_angle(mechanism, 0, test::polynomial({0.0, rate}));
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        const int samples = 3 + static_cast<int>(random.number(0.0, 200.0));
        for (int k = 1; k <= samples; ++k) {
            const double t = 20.0 * k / samples;
            REQUIRE(tracker.advance_to(t));
            const MotionFrame& frame = tracker.frame();
            const double sun = rate * t;
            // relative to the carrier: planet = outer sun, ring = inner planet, and the ring rests
            const double carrier = outer * inner / (outer * inner - 1.0) * sun;
            CAPTURE(t, sun, carrier);
            // roundings of up to 160 rad, passed on by ratios of up to 25
            CHECK(off(mechanism, frame.state, 1, axis, sun) < 1e-11);
            CHECK(off(mechanism, frame.state, 2, axis, carrier) < 1e-11);
            CHECK(std::abs(frame.state.theta[0] - (sun - carrier)) < 1e-11);
            CHECK(std::abs(frame.state.theta[1] - outer * (sun - carrier)) < 1e-10);
            CHECK(frame.velocity_verdict.unique);
            CHECK(frame.velocity_verdict.consistent);
        }
    }
}

TEST_CASE("The case of a differential makes the mean of both wheels", "[core][wheels]") {
    Mechanism mechanism = test::differential();
    test::drive_angle(mechanism, 2, test::polynomial({0.0, 3.0}));
    test::drive_angle(mechanism, 0, test::polynomial({0.0, -1.0, 0.4}));
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const Vec3 x = Vec3(1.0, 2.0, -2.0) / 3.0;
    for (int k = 1; k <= 50; ++k) {
        const double t = 0.2 * k;
        REQUIRE(tracker.advance_to(t));
        const State& state = tracker.frame().state;
        const double left = -t + 0.4 * t * t;
        CAPTURE(t);
        CHECK(off(mechanism, state, 1, x, left) < 1e-11);
        CHECK(off(mechanism, state, 2, x, 6.0 * t - left) < 1e-11);
        CHECK(off(mechanism, state, 3, x, 3.0 * t) < 1e-11);
    }
}

TEST_CASE("A rack moves by the radius for each radian, over many turns", "[core][wheels]") {
    const double r = GENERATE(0.4, -0.15);
    Mechanism mechanism = test::rack_and_pinion(r);
    test::drive_angle(mechanism, 0, test::polynomial({0.0, 5.0}));
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const Vec3 axis = Vec3(2.0, 2.0, 1.0) / 3.0;
    const Vec3 along = perpendicular_to(axis);
    for (int k = 1; k <= 60; ++k) {
        const double t = 0.3 * k;
        REQUIRE(tracker.advance_to(t));
        const State& state = tracker.frame().state;
        // d runs from the rack to the pinion, which stays where it is
        const Vec3 moved = -r * 5.0 * t * along;
        CHECK((state.r[2] - mechanism.bodies[2].r - moved).norm() < 1e-11);
        CHECK(off(mechanism, state, 1, axis, 5.0 * t) < 1e-11);
    }
}

TEST_CASE(
    "A second planet repeats one equation, and its wheels are found to contradict if they do not fit",
    "[core][wheels]") {
    const auto rank_with_second_planet = [](double turned) {
        Mechanism mechanism = test::planetary_gear(-4.0 / 3.0, 0.3);
        test::SceneBuilder scene;
        scene.mechanism = mechanism;
        const Vec3 axis(2.0, -1.0, 2.0);
        const Vec3 arm = -1.05 * perpendicular_to(axis);
        const int planet = scene.add_body("second", arm);
        scene.add_joint("revolute", 2, planet, arm, axis);
        scene.add_wheels("gear", 1, planet, Vec3::Zero(), arm, axis, axis, -4.0 / 3.0);
        Joint& inner = scene.add_wheels("gear", planet, 0, arm, Vec3::Zero(), axis, axis, 0.3);
        inner.geometry.u_j_local =
            Eigen::AngleAxisd(turned, inner.geometry.s_j_local) * inner.geometry.u_j_local;
        return test::rank_of(scene.mechanism);
    };
    const RankReport fits = rank_with_second_planet(0.0);
    CHECK(fits.rows == 5 * 4 + 2 * 4);
    CHECK(fits.columns == 4 * 6 + 4);
    CHECK(fits.rank == fits.rows - 1);
    // the same Jacobian, but no pose satisfies all rows
    CHECK(rank_with_second_planet(1e-3).residual > 1e-5);
}

TEST_CASE("The turns of a mesh are the fewest that fit", "[core][wheels]") {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        test::Random random(seed);
        const double p = std::floor(random.number(5.0, 60.0));
        const double q = std::floor(random.number(5.0, 60.0));
        const double ratio = (random.number() < 0.0 ? -1.0 : 1.0) * p / q;
        const auto period = static_cast<int>(q / std::gcd(static_cast<int>(p), static_cast<int>(q)));
        const int turns = static_cast<int>(random.number(0.0, 0.999) * period) - (period - 1) / 2;
        const double whole = 2.0 * kPi * std::floor(random.number(-3.0, 4.0));
        CAPTURE(seed, p, q, turns);
        // half a period may be counted either way
        const int found = turns_of_mesh(2.0 * kPi * ratio * turns + whole, ratio);
        CHECK((found == turns || (2 * turns == period && found == -turns)));
    }
}
