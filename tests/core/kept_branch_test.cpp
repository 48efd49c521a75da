#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/branches.hpp"
#include "tests/support/driven_linkages.hpp"
#include "tests/support/number_from.hpp"

using namespace jw;
using namespace jw::test;

namespace {

/// Loops of each class; JW_BRANCH_LOOPS asks for another number. Of 10,000 one or two end as undecided: those
/// of 1 mm with a margin of some 1e-9.
unsigned share() { return number_from("JW_BRANCH_LOOPS", 60); }

/// End of a motion, and the distance of its worst pose from the branch of its start.
struct Followed {
    double worst = 0.0;  ///< in sizes
    double until = 0.0;
    int samples = 0;
};

Followed follow(const DrivenLoop& loop, int steps) {
    System system(loop.mechanism, everything(loop.mechanism));
    MotionTracker tracker(system, start_state(loop.mechanism), 0.0);
    Followed out;
    for (int k = 1; k <= steps && tracker.advance_to(static_cast<double>(k) / steps); ++k) {
        const State& state = tracker.frame().state;
        const Vec3 found =
            state.r[at(loop.body)] + rotation_matrix(state.p[at(loop.body)]) * loop.point_local;
        out.worst = std::max(out.worst, (found - loop.expected(tracker.frame().t)).norm() / loop.size);
        ++out.samples;
    }
    out.until = tracker.frame().t;
    return out;
}

template <class Generate>
void check_class(unsigned seed, Generate&& generate, unsigned count = share()) {
    for (unsigned k = 0; k < count; ++k) {
        Random random(seed + k);
        const DrivenLoop loop = generate(random, log_uniform(random, 1e-9, 0.3));
        const int steps = static_cast<int>(log_uniform(random, 1.0, 2000.0));
        CAPTURE(seed + k, loop.name, loop.margin, steps, loop.size);
        const Followed followed = follow(loop, steps);
        CHECK(followed.until == 1.0);
        CHECK(followed.samples == steps);
        // branches are 2 sqrt(margin) apart where they come nearest
        CHECK(followed.worst < 1e-7);
    }
}

}  // namespace

TEST_CASE(
    "Driven four-bars stay on their branch, however near to folding and coarsely sampled", "[branches]") {
    check_class(1000, driven_four_bar);
}

TEST_CASE("A sample near folding is as exact as any other", "[branches]") {
    // of a millimetre: with Newton's tolerance alone the ninth sample is off by 1.9e-6 sizes
    const auto four_bar = std::pair(&driven_four_bar, 10450U);
    // Newton's method stops with a residual of 7e-8: with three corrections the 71st sample is off by 9e-7
    const auto slider_crank = std::pair(&driven_slider_crank, 6322U);
    for (const auto& [generate, seed] : {four_bar, slider_crank}) {
        Random random(seed);
        const DrivenLoop loop = generate(random, log_uniform(random, 1e-9, 0.3));
        const Followed followed = follow(loop, static_cast<int>(log_uniform(random, 1.0, 2000.0)));
        CAPTURE(seed, loop.margin, loop.size);
        CHECK(followed.until == 1.0);
        CHECK(followed.worst < 1e-9);
    }
}

TEST_CASE("Driven slider-cranks stay on their branch", "[branches]") {
    check_class(2000, driven_slider_crank);
}

TEST_CASE("Driven spatial loops stay on their branch", "[branches]") {
    check_class(3000, driven_spatial_loop);
}

TEST_CASE("Universal joints bent through a right angle stay on their branch", "[branches]") {
    // shafts bent by 84 to 89.8 deg; the steps grow with the inverse of the rest to 90 deg
    check_class(
        4000,
        [](Random& random, double margin) {
            return bent_universal_joint(random, 3.3e-3 * std::pow(margin / 1e-9, 0.175));
        },
        share() / 5);
}

TEST_CASE("Loops in a row stay on their branch", "[branches]") { check_class(5000, driven_row); }

TEST_CASE("Driven spherical loops stay on their branch", "[branches]") {
    check_class(9000, driven_spherical_loop);
}

TEST_CASE("A loop driven by the coupler of another stays on its branch", "[branches]") {
    check_class(10000, driven_coupler_point, share() / 3);
}

TEST_CASE("A parallelogram passes its change points wherever samples lie", "[branches]") {
    // samples on a change point, and up to 3 % of an interval to both sides of it
    for (unsigned k = 0; k < share(); ++k) {
        Random random(6000 + k);
        const Place place = random_place(random);
        const int steps = 2 * static_cast<int>(log_uniform(random, 2.0, 300.0));
        const double off = k % 4 == 0 ? 0.0 : log_uniform(random, 1e-9, 0.03) * (k % 2 == 0 ? 1.0 : -1.0);
        // the crank is in line with the ground at turns of 0 and 1/2
        const double start = -(std::floor(steps / 4.0) + off) / steps * 2.0 * std::numbers::pi;
        const double length = random.number(1.2, 2.5);
        const bool turns_against = k / 4 % 2 == 1;
        const DrivenLoop loop = driven_parallelogram(place, length, start, turns_against);
        CAPTURE(6000 + k, steps, off, length, loop.size, turns_against);
        const Followed followed = follow(loop, steps);
        CHECK(followed.until == 1.0);
        // within 1e-6 of a change point positions are known to the root of rounding
        CHECK(followed.worst < 1e-6);
    }
}

TEST_CASE(
    "A crank that cannot pass stops where it turns back, however coarsely it is sampled", "[branches]") {
    for (unsigned k = 0; k < share(); ++k) {
        Random random(7000 + k);
        const Place place = random_place(random);
        // crank 1, coupler 2, rocker 1, ground 2 + gap: b + c < a + d in line, so the crank turns back before
        const double gap = log_uniform(random, 1e-8, 1e-1);
        const double d = 2.0 + gap;
        const double folds = std::acos((1.0 + d * d - 9.0) / (2.0 * d));
        const double start = random.number(0.2, 1.2);
        const int steps = static_cast<int>(log_uniform(random, 1.0, 500.0));
        const double side = random.number() > 0.0 ? 1.0 : -1.0;
        const Mechanism mechanism = four_bar_of(place, {1.0, 2.0, 1.0, d}, 0.0, start, 1.0, side).mechanism;
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        CAPTURE(7000 + k, gap, steps, place.size);
        bool stopped = false;
        for (int n = 1; n <= steps && !stopped; ++n) {
            stopped = !tracker.advance_to(static_cast<double>(n) / steps);
        }
        REQUIRE(stopped);
        const double turns_back = (folds - start) / (2.0 * std::numbers::pi);
        CHECK(tracker.frame().t <= turns_back);
        // as near as rounding lets a step be proved: the margin squared is 1e-11 there, and proportional to
        // the root of the gap times the time that is left
        CHECK(turns_back - tracker.frame().t < 1e-10 / std::sqrt(gap));
        const PositionFailure& failure = *tracker.failure();
        CHECK(failure.cause == FailureCause::turning_point);
        CHECK(failure.t == Approx(turns_back).epsilon(1e-7));
    }
}

TEST_CASE("A motion there and back ends where it began, and fine samples meet coarse ones", "[branches]") {
    const std::array classes{driven_four_bar, driven_slider_crank,   driven_spatial_loop,
                             driven_row,      driven_spherical_loop, driven_coupler_point};
    for (unsigned k = 0; k < share() / 2; ++k) {
        Random random(8000 + k);
        const DrivenLoop loop = classes[k % classes.size()](random, log_uniform(random, 1e-7, 0.1));
        const int steps = static_cast<int>(log_uniform(random, 1.0, 20.0));
        System system(loop.mechanism, everything(loop.mechanism));
        MotionTracker coarse(system, start_state(loop.mechanism), 0.0);
        const State start = coarse.frame().state;
        System fine_system(loop.mechanism, everything(loop.mechanism));
        MotionTracker fine(fine_system, start_state(loop.mechanism), 0.0);
        CAPTURE(8000 + k, loop.name, loop.margin, steps);
        const auto apart = [&](const State& a, const State& b) { return movement(system, a, b); };
        const double scale = std::max(1.0, loop.size / system.length_unit());
        for (int n = 1; n <= steps; ++n) {
            REQUIRE(coarse.advance_to(0.7 * n / steps));
            for (int m = 1; m <= 40; ++m) { REQUIRE(fine.advance_to(0.7 * (n - 1 + m / 40.0) / steps)); }
            CHECK(apart(coarse.frame().state, fine.frame().state) < 1e-8 * scale);
        }
        for (int n = steps - 1; n >= 0; --n) { REQUIRE(coarse.advance_to(0.7 * n / steps)); }
        CHECK(apart(coarse.frame().state, start) < 1e-8 * scale);
    }
}

TEST_CASE("A motion that starts in a change point is proved from there on", "[branches]") {
    // a crank in line with the ground; the start velocities carry the coupler along without turning it
    for (const int steps : {1, 2, 3, 7, 50}) {
        const Place place{Vec3(0.3, 0.2, -0.1), rotation_matrix(Vec4(0.5, 0.5, -0.5, 0.5)), 0.7};
        DrivenLoop loop = driven_parallelogram(place, 1.7, 0.0, false);
        const Vec3 omega = 2.0 * std::numbers::pi * place.along(0, 0, 1);
        std::vector<Body>& bodies = loop.mechanism.bodies;
        for (const auto& [body, pivot] : {std::pair(1, place.at(0, 0)), std::pair(3, place.at(1.7, 0))}) {
            bodies[at(body)].omega_local = rotation_matrix(bodies[at(body)].p).transpose() * omega;
            bodies[at(body)].r_dot = omega.cross(bodies[at(body)].r - pivot);
        }
        bodies[2].r_dot = omega.cross(place.at(1, 0) - place.at(0, 0));
        CAPTURE(steps);
        const Followed followed = follow(loop, steps);
        CHECK(followed.until == 1.0);
        CHECK(followed.worst < 1e-6);
    }
}

TEST_CASE("A step is proved with its own velocities, whatever was asked at its start before", "[branches]") {
    // the body turns about its origin, so that only its ω' tells one velocity from the other
    SceneBuilder scene;
    const int crank = scene.add_body("crank", Vec3::Zero());
    Joint& hinge = scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ());
    scene.measure_angle(hinge, Vec3::UnitX(), Vec3::UnitX());
    drive(scene.mechanism, 0, 0.0, 1.0);
    const System system(scene.mechanism, everything(scene.mechanism));
    const State from = start_state(scene.mechanism);
    const Motion at_rest = zero_motion(scene.mechanism);
    Motion turning = at_rest;
    turning.omega_local[at(crank)] = 2.0 * std::numbers::pi * scene.local(crank, Vec3::UnitZ());
    constexpr double kTime = 0.02;  // 0.13 rad
    State to = from;
    to.p[at(crank)] = turned_local(from.p[at(crank)], kTime * turning.omega_local[at(crank)]);
    StepProof fresh(system);
    REQUIRE(fresh.holds({0.0, &from, &turning}, {kTime, &to, &turning}));
    StepProof asked(system);
    REQUIRE(asked.decides_at({0.0, &from, &at_rest}));
    CHECK(asked.holds({0.0, &from, &turning}, {kTime, &to, &turning}));
}
