#include "core/kinematics/turning_point.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/driven_linkages.hpp"
#include "tests/support/number_from.hpp"

using namespace jw;
using namespace jw::test;

namespace {

/// Loops of each class; JW_BRANCH_LOOPS asks for another number.
unsigned share() { return number_from("JW_BRANCH_LOOPS", 40); }

/// Two cranks of length 1 on a ground of 2, both driven, whose couplers of length b meet.
Mechanism five_bar(double b, double rate_of_second) {
    SceneBuilder scene;
    const Vec3 z = Vec3::UnitZ();
    const double phi = 1.0;
    const Vec3 A(std::cos(phi), std::sin(phi), 0);
    const Vec3 B(2.0 - std::cos(phi), std::sin(phi), 0);
    const double half = 0.5 * (B - A).norm();
    const Vec3 C(1.0, std::sin(phi) + std::sqrt(b * b - half * half), 0);
    const int first = scene.add_body("first crank", 0.5 * A);
    const int second = scene.add_body("second crank", 0.5 * (B + Vec3(2, 0, 0)));
    const int left = scene.add_body("left coupler", 0.5 * (A + C));
    const int right = scene.add_body("right coupler", 0.5 * (B + C));
    scene.measure_angle(scene.add_joint("revolute", 0, first, Vec3::Zero(), z), Vec3::UnitX(), A);
    scene.measure_angle(
        scene.add_joint("revolute", 0, second, Vec3(2, 0, 0), z), Vec3::UnitX(), B - Vec3(2, 0, 0));
    scene.add_joint("revolute", first, left, A, z);
    scene.add_joint("revolute", left, right, C, z);
    scene.add_joint("revolute", second, right, B, z);
    drive(scene.mechanism, 0, phi, 1.0);
    drive(scene.mechanism, 1, std::numbers::pi - phi, rate_of_second / (2.0 * std::numbers::pi));
    return scene.mechanism;
}

PositionFailure end_of(const Mechanism& mechanism, int steps) {
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    for (int n = 1; n <= steps; ++n) {
        if (!tracker.advance_to(static_cast<double>(n) / steps)) { return *tracker.failure(); }
    }
    FAIL("the motion should end");
    return {};
}

}  // namespace

// the crank turns back where its pin is as high above the slide as the coupler is long
TEST_CASE("A slider-crank that locks is proved to turn back, whatever its size and place", "[branches]") {
    for (unsigned k = 0; k < share(); ++k) {
        Random random(20000 + k);
        const Place place = random_place(random);
        const double b =
            random.number() > 0.0 ? random.number(0.1, 0.9) : 1.0 - log_uniform(random, 1e-6, 0.1);
        const double start = random.number(-0.9, 0.9) * std::asin(b);
        const double side = random.number() > 0.0 ? 1.0 : -1.0;
        const int steps = static_cast<int>(log_uniform(random, 1.0, 500.0));
        CAPTURE(20000 + k, b, start, steps, place.size);
        const PositionFailure failure =
            end_of(slider_crank_of(place, {1.0, b, 0.0}, 0.0, start, 1.0, side).mechanism, steps);
        CHECK(failure.cause == FailureCause::turning_point);
        CHECK(failure.t == Approx((std::asin(b) - start) / (2.0 * std::numbers::pi)).epsilon(1e-7));
    }
}

TEST_CASE("A crank that turns on is never proved to turn back", "[branches]") {
    const std::array classes{
        driven_four_bar, driven_slider_crank, driven_spatial_loop, driven_row, driven_spherical_loop};
    for (unsigned k = 0; k < share(); ++k) {
        Random random(21000 + k);
        const DrivenLoop loop = classes[k % classes.size()](random, log_uniform(random, 1e-8, 0.1));
        System system(loop.mechanism, everything(loop.mechanism));
        MotionTracker tracker(system, start_state(loop.mechanism), 0.0);
        for (int n = 1; n <= 20; ++n) {
            CAPTURE(21000 + k, loop.name, loop.margin, loop.size, n);
            if (!tracker.advance_to(n / 20.0)) {
                // one loop in two thousand: of a millimetre, far from the origin; or as many steps as one
                // interval may take are not enough
                CHECK(
                    tracker.failure()->cause == (tracker.frame().tries == 50000 ? FailureCause::no_convergence
                                                                                : FailureCause::undecided));
                break;
            }
            const MotionFrame& frame = tracker.frame();
            CHECK_FALSE(turns_back(system, frame.state, frame.velocity, frame.t, 1.0));
            CHECK_FALSE(turns_back(system, frame.state, frame.velocity, frame.t, -1.0));
        }
    }
}

// beside its folding the coupler turns at 350 rad/s, by 2e-5 rad in a step that can be proved
TEST_CASE("A motion that needs too many steps ends without a verdict about the poses beyond", "[branches]") {
    Random random(28672);
    const DrivenLoop loop = driven_spatial_loop(random, log_uniform(random, 1e-8, 0.1));
    const PositionFailure failure = end_of(loop.mechanism, 1);
    CHECK(failure.cause == FailureCause::no_convergence);
    CHECK(failure.iterations == 0);
    CHECK(failure.t == Approx(0.997).margin(0.001));
}

TEST_CASE("A crank that turns on is not said to turn back where no step can be proved", "[branches]") {
    // its margin of 2e-9 looks as if it had a root
    Random random(6869);
    const DrivenLoop loop = driven_spatial_loop(random, log_uniform(random, 1e-9, 0.3));
    const int steps = static_cast<int>(log_uniform(random, 1.0, 2000.0));
    CAPTURE(loop.name, loop.margin, steps);
    CHECK(end_of(loop.mechanism, steps).cause == FailureCause::undecided);
}

TEST_CASE("Of several drivers that move at once it is not proved that they turn back", "[branches]") {
    CHECK(end_of(five_bar(1.2, 0.0), 100).cause == FailureCause::turning_point);
    CHECK(end_of(five_bar(1.2, -0.5), 100).cause == FailureCause::likely_turning_point);
}

TEST_CASE("From a dead centre of its driver no motion is followed, however it is sampled", "[branches]") {
    // coupler and rocker in line: two branches lead back, and none leads on
    const FourBarLinks links{2.0, 1.5, 1.0, 3.0};
    const double locks = std::acos((4.0 + 9.0 - 2.5 * 2.5) / 12.0);
    for (const int steps : {7, 20, 100, 1000}) {
        CAPTURE(steps);
        const auto end = [&](double sense) {
            return end_of(four_bar_of({}, links, 0.0, locks, sense, 1.0).mechanism, steps);
        };
        CHECK(end(1.0).cause == FailureCause::cannot_close);
        CHECK(end(-1.0).cause == FailureCause::undecided);
        CHECK(end(-1.0).t == 0.0);
    }
}

TEST_CASE(
    "A driver that stands still at its dead centre stays there, and is not followed when it moves",
    "[branches]") {
    const double locks = std::acos((4.0 + 9.0 - 2.5 * 2.5) / 12.0);
    for (const double begins : {0.0, 0.5}) {
        for (const int steps : {7, 100}) {
            CAPTURE(begins, steps);
            Mechanism mechanism = four_bar_of({}, {2.0, 1.5, 1.0, 3.0}, 0.0, locks, 1.0, 1.0).mechanism;
            // back, from rest and without acceleration at first
            mechanism.drivers[0].function = TimeFunction{{}, {}, {{locks, locks - 0.5, begins, 1.0}}};
            const PositionFailure failure = end_of(mechanism, steps);
            CHECK(failure.cause == FailureCause::undecided);
            CHECK(failure.t == Approx(begins).margin(1e-12));
        }
    }
    // there and back within one interval: t⁴ - t³ is 0 at both ends, and so are its derivatives at the start
    Mechanism mechanism = four_bar_of({}, {2.0, 1.5, 1.0, 3.0}, 0.0, locks, 1.0, 1.0).mechanism;
    mechanism.drivers[0].function = TimeFunction{{locks, 0.0, 0.0, -1.0, 1.0}, {}, {}};
    for (const int steps : {1, 7}) {
        CAPTURE(steps);
        const PositionFailure failure = end_of(mechanism, steps);
        CHECK(failure.cause == FailureCause::undecided);
        CHECK(failure.t == 0.0);
    }
}
