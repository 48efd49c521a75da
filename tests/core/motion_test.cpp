#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/driven.hpp"

/// The tracker at change points, dead ends and over long frames.
using namespace jw;
using test::kPi;

namespace {

/// Angle by which the coupler has turned; zero on the parallel branch.
double coupler_turn(const State& start, const State& state) {
    return turn_local_between(start.p[2], state.p[2]).norm();
}

}  // namespace

TEST_CASE(
    "A parallelogram driven through its change points stays on its branch and reports them",
    "[core][motion]") {
    // frames of π/40 hit φ = 0 and π exactly; 0.07 and 0.0331 do not
    const double step = GENERATE(kPi / 40.0, 0.07, 0.0331, 0.4);
    const double sense = GENERATE(1.0, -1.0);
    const double start = -0.5 * kPi;
    const Mechanism mechanism = test::driven(test::parallelogram(start), 0, sense);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const State first = tracker.frame().state;
    int reported = 0;
    for (int k = 1; k * step < 4.0 * kPi; ++k) {
        const double t = k * step;
        CAPTURE(step, sense, t);
        REQUIRE(tracker.advance_to(t));
        const MotionFrame& frame = tracker.frame();
        const double phi = start + sense * t;
        // within 1e-6 of the singular pose itself position errors are √ of rounding
        const double from_change = std::abs(std::sin(phi));
        const double tolerance = from_change < 1e-6 ? 1e-6 : 1e-12 / from_change;
        CHECK(coupler_turn(first, frame.state) < tolerance);
        const Vec3 A(std::cos(phi), std::sin(phi), 0.0);
        CHECK((frame.state.r[2] - A).norm() < tolerance);
        CHECK(frame.velocity.omega_local[2].norm() < 10.0 * tolerance);
        CHECK(frame.velocity_verdict.consistent);
        // by pivots the ratio is sin φ times a number near 1
        if (from_change < 1e-4) { CHECK(frame.change_point); }
        if (from_change > 1e-2) { CHECK_FALSE(frame.change_point); }
        reported += frame.change_point ? 1 : 0;
    }
    if (step == kPi / 40.0) { CHECK(reported == 4); }
    // φ = 0 and π, wherever the frames are
    REQUIRE(tracker.crossings().size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        // steps are proved up to there
        CHECK(std::abs(tracker.crossings()[k] - (0.5 + static_cast<double>(k)) * kPi) < 1e-3);
    }
}

TEST_CASE(
    "A parallelogram that starts in its change point follows the velocity that it is given",
    "[core][motion]") {
    // at φ = 0 both branches are open; the start velocity says which: the coupler carried along y, or turning
    Mechanism mechanism = test::driven(test::parallelogram(0.0), 0, 1.0);
    const bool parallel = GENERATE(true, false);
    const Vec3 z = Vec3::UnitZ();
    const auto local_z = [&](int body) {
        return Vec3(rotation_matrix(mechanism.bodies[static_cast<std::size_t>(body)].p).transpose() * z);
    };
    mechanism.bodies[1].omega_local = local_z(1);
    mechanism.bodies[2].r_dot = Vec3::UnitY();  // its origin is at A
    // |B - A| = 2 to second order: (φ - ψ)(3 φ + ψ) = 0, so the contrary branch has ψ̇ = -3 φ̇ and the bar
    // of 2 turns by (ψ̇ - φ̇)/2 = -2
    mechanism.bodies[2].omega_local = parallel ? Vec3(Vec3::Zero()) : Vec3(-2.0 * local_z(2));
    mechanism.bodies[3].omega_local = parallel ? local_z(3) : Vec3(-3.0 * local_z(3));
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const State first = tracker.frame().state;
    CAPTURE(parallel);
    for (int k = 1; k <= 20; ++k) { REQUIRE(tracker.advance_to(0.02 * k)); }
    const double turn = coupler_turn(first, tracker.frame().state);
    if (parallel) {
        CHECK(turn < 1e-9);
    } else {
        CHECK(turn > 0.2);
    }
}

TEST_CASE("A four-bar driven past its dead end stops there, with the last good pose", "[core][motion]") {
    // crank 2, coupler 1.5, rocker 1, ground 3: the crank locks where coupler and rocker are in line
    const test::FourBarLengths l{2.0, 1.5, 1.0, 3.0};
    const double locks = std::acos((4.0 + 9.0 - 2.5 * 2.5) / 12.0);
    const double step = GENERATE(0.01, 0.1);
    const Mechanism mechanism = test::driven(test::four_bar_at(0.5, l), 0, 0.7);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const double end = (locks - 0.5) / 0.7;
    CAPTURE(step, locks, end);
    bool stopped = false;
    double last_good = 0.0;
    for (int k = 1; k * step < end + 1.0; ++k) {
        last_good = tracker.frame().t;
        if (!tracker.advance_to(k * step)) {
            stopped = true;
            break;
        }
        CHECK_FALSE(tracker.failure().has_value());
    }
    REQUIRE(stopped);
    REQUIRE(tracker.failure().has_value());
    const MotionFrame& frame = tracker.frame();
    CHECK(frame.t >= last_good);
    CHECK(frame.t <= end);
    CHECK(end - frame.t < step);
    // the turning point itself, not the gap at the time that was asked for
    CHECK(tracker.failure()->cause == FailureCause::turning_point);
    CHECK(tracker.failure()->t == Approx(end).margin(1e-9));
    // the last pose is valid: all equations hold, and nothing in it is NaN
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(frame.state, frame.t);
    CHECK(assembler.phi().cwiseAbs().maxCoeff() < 1e-12);
    CHECK(std::isfinite(test::difference(frame.velocity, zero_motion(mechanism))));
    CHECK(std::isfinite(test::difference(frame.acceleration, zero_motion(mechanism))));
    // a second try changes nothing
    CHECK_FALSE(tracker.advance_to(end + 1.0));
    CHECK(tracker.frame().t <= end);
}

TEST_CASE("Motion can be followed backwards to where it began", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::bennett(0.7), 0, 1.0);
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const State first = tracker.frame().state;
    for (int k = 1; k <= 30; ++k) { REQUIRE(tracker.advance_to(0.1 * k)); }
    for (int k = 29; k >= 0; --k) { REQUIRE(tracker.advance_to(0.1 * k)); }
    for (std::size_t b = 0; b < first.r.size(); ++b) {
        // each pose is assembled to rounding, which does not accumulate
        CHECK((tracker.frame().state.r[b] - first.r[b]).norm() < 1e-12);
        CHECK(turn_local_between(first.p[b], tracker.frame().state.p[b]).norm() < 1e-12);
    }
}

TEST_CASE("Long frames are cut into steps and come to the same poses", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::four_bar_at(0.7), 0, 1.0);
    System fine_system(mechanism, everything(mechanism));
    System coarse_system(mechanism, everything(mechanism));
    MotionTracker fine(fine_system, start_state(mechanism), 0.0);
    MotionTracker coarse(coarse_system, start_state(mechanism), 0.0);
    const double frame = 2.5;
    for (int k = 1; k <= 4; ++k) {
        for (int m = 1; m <= 50; ++m) { REQUIRE(fine.advance_to(frame * (k - 1) + 0.05 * m)); }
        REQUIRE(coarse.advance_to(frame * k));
        CAPTURE(k, coarse.frame().substeps);
        for (std::size_t b = 0; b < 4; ++b) {
            CHECK((coarse.frame().state.r[b] - fine.frame().state.r[b]).norm() < 1e-12);
        }
        CHECK(test::difference(coarse.frame().velocity, fine.frame().velocity) < 1e-11);
    }
}

TEST_CASE("Switching the rows of p1 on the way changes no motion", "[core][motion]") {
    // axes that turn with their bodies
    const auto scene = [](ParallelForm form) {
        Mechanism mechanism = test::driven(test::bennett(0.7), 0, 1.0);
        for (Joint& joint : mechanism.joints) { joint.parallel_form = form; }
        return mechanism;
    };
    const Mechanism with_rule = scene(ParallelForm::rule);
    const Mechanism with_pair = scene(ParallelForm::pair);
    System rule_system(with_rule, everything(with_rule));
    System pair_system(with_pair, everything(with_pair));
    MotionTracker rule(rule_system, start_state(with_rule), 0.0);
    MotionTracker pair(pair_system, start_state(with_pair), 0.0);
    int switches = 0;
    for (int k = 1; k <= 60; ++k) {
        REQUIRE(rule.advance_to(0.1 * k));
        REQUIRE(pair.advance_to(0.1 * k));
        switches += rule.frame().rows_switched ? 1 : 0;
        CHECK_FALSE(pair.frame().rows_switched);
        CHECK(test::difference(rule.frame().velocity, pair.frame().velocity) < 1e-11);
        CHECK(test::difference(rule.frame().acceleration, pair.frame().acceleration) < 1e-10);
    }
    CHECK(switches > 0);
}

TEST_CASE("Turns of a crank do not depend on how many moments are asked for", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::four_bar_at(0.9), 0, 2.0 * kPi);
    constexpr double end = 3.7;
    const auto angles_after = [&](int intervals) {
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        for (int k = 1; k <= intervals; ++k) { REQUIRE(tracker.advance_to(end * k / intervals)); }
        std::vector<double> angles;
        for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
            const MotionFrame& frame = tracker.frame();
            angles.push_back(relative_angle(mechanism.joints[j], frame.state) + 2.0 * kPi * frame.turns[j]);
        }
        // and all the way back
        REQUIRE(tracker.advance_to(0.0));
        CHECK(tracker.frame().turns == std::vector<int>(mechanism.joints.size(), 0));
        return angles;
    };
    const std::vector<double> angles = angles_after(1);
    // rounding of 24 rad
    CHECK(std::abs(angles[0] - (0.9 + 2.0 * kPi * end)) < 1e-13);
    for (const int intervals : {2, 11, 400}) {
        const std::vector<double> others = angles_after(intervals);
        for (std::size_t j = 0; j < angles.size(); ++j) { CHECK(std::abs(others[j] - angles[j]) < 1e-12); }
    }
    // the rocker swings, and the coupler goes round against the crank
    CHECK(std::abs(angles[3]) < kPi);
    CHECK(std::abs(angles[1] + 2.0 * kPi * end) < kPi);
}

TEST_CASE("A driven angle begins with the turns that its driver asks for", "[core][motion]") {
    Mechanism mechanism = test::four_bar_at(0.9);
    test::drive_angle(mechanism, 0, test::polynomial({0.9 - 4.0 * kPi, 1.0}));
    System system(mechanism, everything(mechanism));
    const MotionTracker tracker(system, start_state(mechanism), 0.0);
    CHECK(tracker.frame().turns == std::vector<int>{-2, 0, 0, 0});
}
