#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/driven.hpp"

/// Position, velocity and acceleration of mechanisms that have closed forms, followed over a turn.
using namespace jw;
using test::kPi;
using test::radians;

namespace {

constexpr double kTolerance = 1e-12;  // rounding of the pose (1e-15) over singular values down to 0.2, twice

constexpr double kRate = 1.7;
constexpr double kAcceleration = 0.4;

/// Calls `check(phi, phi_dot, phi_ddot, mechanism, frame)` over a little more than a turn of joint 0.
template <class Check>
void follow(const Mechanism& undriven, int joint, const Check& check) {
    const Mechanism mechanism = test::driven(undriven, joint, kRate, kAcceleration);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const double start = tracker.frame().state.r.empty() ? 0.0 : mechanism.drivers[0].function.at(0.0).f;
    for (int k = 0; k <= 60; ++k) {
        const double t = 0.05 * k;
        CAPTURE(t);
        if (k > 0) { REQUIRE(tracker.advance_to(t)); }
        CHECK(tracker.frame().velocity_verdict.unique);
        CHECK(tracker.frame().velocity_verdict.consistent);
        CHECK(tracker.frame().acceleration_verdict.consistent);
        check(
            start + kRate * t + 0.5 * kAcceleration * t * t, kRate + kAcceleration * t, kAcceleration,
            mechanism, tracker.frame());
    }
}

/// f, df/dt and d²f/dt² of a function of the crank's angle, from its three derivatives by it.
struct ByAngle {
    double f, f_1, f_2;
    double rate(double phi_dot) const { return f_1 * phi_dot; }
    double acceleration(double phi_dot, double phi_ddot) const {
        return f_2 * phi_dot * phi_dot + f_1 * phi_ddot;
    }
};

}  // namespace

TEST_CASE(
    "A slider-crank moves as r cosφ + √(l² - r² sin²φ), with both derivatives", "[core][closed_forms]") {
    const double r = 1.0;
    const double l = 2.5;
    follow(
        test::slider_crank(r, l, 0.3), 0,
        [&](double phi, double phi_dot, double phi_ddot, const Mechanism&, const MotionFrame& frame) {
            const double sine = std::sin(phi);
            const double cosine = std::cos(phi);
            const double root = std::sqrt(l * l - r * r * sine * sine);
            const double root_1 = -r * r * sine * cosine / root;
            const double root_2 = (-r * r * (cosine * cosine - sine * sine) - root_1 * root_1) / root;
            const ByAngle x{r * cosine + root, -r * sine + root_1, -r * cosine + root_2};
            const Vec3 position = frame.state.r[3];
            CHECK((position - Vec3(x.f, 0.0, 0.0)).norm() < kTolerance);
            CHECK((frame.velocity.r_dot[3] - Vec3(x.rate(phi_dot), 0.0, 0.0)).norm() < kTolerance);
            // accelerations reach 10
            CHECK(
                (frame.acceleration.r_dot[3] - Vec3(x.acceleration(phi_dot, phi_ddot), 0.0, 0.0)).norm() <
                10.0 * kTolerance);
        });
}

TEST_CASE(
    "A universal joint turns with the ratio cosβ / (1 - sin²β cos²φ), and its derivative",
    "[core][closed_forms]") {
    for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
        const double b = radians(degrees);
        CAPTURE(degrees);
        follow(
            test::cardan(b, 0.3), 0,
            [&](double phi, double phi_dot, double phi_ddot, const Mechanism& mechanism,
                const MotionFrame& frame) {
                const double denominator = 1.0 - std::pow(std::sin(b) * std::cos(phi), 2);
                const double ratio = std::cos(b) / denominator;
                const double ratio_1 =
                    -std::cos(b) * std::pow(std::sin(b), 2) * std::sin(2.0 * phi) / std::pow(denominator, 2);
                const Measured out = test::joint_angle(mechanism, 1, frame);
                // at 70 deg ratio² is 9 and its derivative 20
                const double size = std::max(1.0, ratio * ratio);
                CHECK(std::abs(out.rate - ratio * phi_dot) < kTolerance * size);
                CHECK(
                    std::abs(out.acceleration - (ratio * phi_ddot + ratio_1 * phi_dot * phi_dot)) <
                    20.0 * kTolerance * size);
            });
    }
}

TEST_CASE("Two universal joints with parallel outer shafts turn one to one", "[core][closed_forms]") {
    for (const double degrees : {0.0, 25.0, 60.0}) {
        CAPTURE(degrees);
        follow(
            test::double_cardan(radians(degrees), 0.3), 0,
            [&](double, double phi_dot, double phi_ddot, const Mechanism& mechanism,
                const MotionFrame& frame) {
                const Measured out = test::joint_angle(mechanism, 3, frame);
                CHECK(std::abs(out.rate - phi_dot) < 10.0 * kTolerance);
                CHECK(std::abs(out.acceleration - phi_ddot) < 100.0 * kTolerance);
            });
    }
}

TEST_CASE("RSSR's rocker stands where the loop closure says, with both derivatives", "[core][closed_forms]") {
    const test::Rssr l;
    Mechanism mechanism = test::driven(test::rssr(0.7, l), 0, kRate, kAcceleration);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    for (int k = 1; k <= 60; ++k) {
        const double t = 0.05 * k;
        REQUIRE(tracker.advance_to(t));
        const double phi = 0.7 + kRate * t + 0.5 * kAcceleration * t * t;
        const double phi_dot = kRate + kAcceleration * t;
        const double psi = l.psi(phi);
        CAPTURE(t, phi, psi);
        // velocities from |B - A|² = L²: (B - A)·(Ḃ - Ȧ) = 0; accelerations from its derivative
        const Vec3 z = Vec3::UnitZ();
        const Vec3 y = Vec3::UnitY();
        const Vec3 rod = l.rocker_end(psi) - l.crank_end(phi);
        const Vec3 arm = l.rocker_end(psi) - l.D;
        const Vec3 A_dot = phi_dot * z.cross(l.crank_end(phi));
        const Vec3 A_ddot = kAcceleration * z.cross(l.crank_end(phi)) - phi_dot * phi_dot * l.crank_end(phi);
        const double psi_dot = rod.dot(A_dot) / rod.dot(y.cross(arm));
        const Vec3 B_dot = psi_dot * y.cross(arm);
        const double psi_ddot = (rod.dot(A_ddot + psi_dot * psi_dot * arm) - (B_dot - A_dot).squaredNorm()) /
                                rod.dot(y.cross(arm));

        const MotionFrame& frame = tracker.frame();
        const Measured out = test::joint_angle(mechanism, 3, frame);
        CHECK(std::abs(std::remainder(out.value - psi, 2.0 * kPi)) < kTolerance);
        CHECK(std::abs(out.rate - psi_dot) < 10.0 * kTolerance);
        CHECK(std::abs(out.acceleration - psi_ddot) < 100.0 * kTolerance);
        // the idle spin of the rod is not unique, and the verdict says so; the equations are consistent
        CHECK_FALSE(frame.velocity_verdict.unique);
        CHECK(frame.velocity_verdict.consistent);
        CHECK(frame.acceleration_verdict.consistent);
        CHECK_FALSE(frame.change_point);
    }
}

TEST_CASE(
    "Bennett keeps the product of its half-angle tangents over the whole turn", "[core][closed_forms]") {
    const test::Bennett l;
    follow(
        test::bennett(0.3, l), 0,
        [&](double phi, double phi_dot, double, const Mechanism& mechanism, const MotionFrame& frame) {
            const Measured next = test::joint_angle(mechanism, 1, frame);
            const Measured opposite = test::joint_angle(mechanism, 2, frame);
            const Measured last = test::joint_angle(mechanism, 3, frame);
            // sine and cosine instead of tangents, which are infinite once in a turn
            const double c = l.half_tangents();
            const double half_phi = 0.5 * phi;
            const double half = 0.5 * next.value;
            const double miss = std::sin(half_phi) * std::sin(half) - c * std::cos(half_phi) * std::cos(half);
            CHECK(std::abs(miss) < 10.0 * kTolerance);
            CHECK(std::abs(std::remainder(opposite.value + phi, 2.0 * kPi)) < 10.0 * kTolerance);
            CHECK(std::abs(std::remainder(last.value + next.value, 2.0 * kPi)) < 10.0 * kTolerance);
            // d/dt: θ̇2 = -φ̇ sin θ2 / sin φ, written without division
            CHECK(std::abs(next.rate * std::sin(phi) + phi_dot * std::sin(next.value)) < 100.0 * kTolerance);
        });
}

TEST_CASE("A parallelogram's coupler is carried without turning", "[core][closed_forms]") {
    // the motion stays between two change points
    Mechanism mechanism = test::driven(test::parallelogram(0.4), 0, 0.5);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    for (int k = 1; k <= 50; ++k) {
        REQUIRE(tracker.advance_to(0.1 * k));
        CHECK(tracker.frame().velocity.omega_local[2].norm() < kTolerance);
        CHECK(std::abs(tracker.frame().velocity.r_dot[2].norm() - 0.5) < kTolerance);
        CHECK_FALSE(tracker.frame().change_point);
    }
}
