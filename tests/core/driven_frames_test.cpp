#include <catch2/catch.hpp>

#include "core/kinematics/driven_frames.hpp"
#include "tests/support/driven.hpp"

/// The quick solution at each time, compared with the one that decides ranks.
using namespace jw;

namespace {

struct Moment {
    State state;
    Motion velocity;
    Motion acceleration;
};

/// Position by Newton from `near` and one step beyond its tolerance, velocity and acceleration by pivoted
/// least squares.
Moment thorough(const System& system, const Moment& near, double t) {
    NewtonStepper<OmegaLocal> newton(system);
    newton.start(near.state, t);
    REQUIRE(solve(newton).converged);
    Kinematics<OmegaLocal> kinematics(system);
    kinematics.set_state(newton.state(), t);
    const State state = kinematics.corrected_state();
    kinematics.set_state(state, t);
    const Motion velocity = kinematics.solve_velocity(zero_motion(system.mechanism())).velocity;
    return {state, velocity, kinematics.solve_acceleration(velocity).acceleration};
}

}  // namespace

TEST_CASE("Driven frames are those of the thorough way, with a few frames declined", "[core][motion]") {
    const auto scene = GENERATE(
        test::four_bar_at(0.4), test::slider_crank(1.0, 2.5, 0.3), test::bennett(0.7), test::bricard(0.9));
    const Mechanism mechanism = test::driven(scene, 0, 1.0, 0.3);
    const System system(mechanism, everything(mechanism));
    REQUIRE(DrivenFrames::can_follow(system));
    DrivenFrames quick(system);
    Moment frame{start_state(mechanism), zero_motion(mechanism), zero_motion(mechanism)};
    frame = thorough(system, frame, 0.0);
    bool sound = quick.start(frame.state, frame.velocity, frame.acceleration, 0.0);
    const Motion none = zero_motion(mechanism);
    int declined = 0;
    for (int k = 1; k <= 60; ++k) {
        const double t = 0.05 * k;
        CAPTURE(t);
        const Moment expected = thorough(system, frame, t);
        if (sound && quick.advance(t)) {
            quick.write(frame.state, frame.velocity, frame.acceleration);
        } else {
            ++declined;
            frame = expected;
            sound = quick.start(frame.state, frame.velocity, frame.acceleration, t);
        }
        for (const int body : system.moving_bodies()) {
            const auto b = static_cast<std::size_t>(body);
            // rounding of 1e-15 over singular values down to 0.1 (pivots, which are squares, down to 1e-2)
            CHECK((frame.state.r[b] - expected.state.r[b]).norm() < 1e-13);
            CHECK(turn_local_between(frame.state.p[b], expected.state.p[b]).norm() < 1e-13);
        }
        CHECK(
            test::difference(frame.velocity, expected.velocity) <
            1e-12 * (1.0 + test::difference(expected.velocity, none)));
        CHECK(
            test::difference(frame.acceleration, expected.acceleration) <
            1e-12 * (1.0 + test::difference(expected.acceleration, none)));
    }
    // Bricard's mechanism is near a singular position half of the way
    CHECK(declined < 40);
}

TEST_CASE("Driven frames go forth and back, stand still and take any steps", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::four_bar_at(0.4), 0, 1.0, 0.3);
    const System system(mechanism, everything(mechanism));
    DrivenFrames quick(system);
    Moment frame{start_state(mechanism), zero_motion(mechanism), zero_motion(mechanism)};
    frame = thorough(system, frame, 0.0);
    REQUIRE(quick.start(frame.state, frame.velocity, frame.acceleration, 0.0));
    const Motion none = zero_motion(mechanism);
    for (const double t : {0.1, 0.0, 0.0, 0.1, 0.1001, 0.4, 0.5, 0.55, 0.6, 0.2, 0.1, 0.0}) {
        CAPTURE(t);
        REQUIRE(quick.advance(t + 0.05));
        quick.retreat();
        REQUIRE(quick.advance(t));
        const Moment expected = thorough(system, frame, t);
        quick.write(frame.state, frame.velocity, frame.acceleration);
        for (const int body : system.moving_bodies()) {
            CHECK((frame.state.r[at(body)] - expected.state.r[at(body)]).norm() < 1e-13);
        }
        CHECK(
            test::difference(frame.acceleration, expected.acceleration) <
            1e-12 * (1.0 + test::difference(expected.acceleration, none)));
    }
}

TEST_CASE("Driven frames decline what needs a rank decision, and stay where they were", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::parallelogram(0.5), 0, -1.0);
    const System system(mechanism, everything(mechanism));
    DrivenFrames quick(system);
    Moment frame{start_state(mechanism), zero_motion(mechanism), zero_motion(mechanism)};
    frame = thorough(system, frame, 0.0);
    REQUIRE(quick.start(frame.state, frame.velocity, frame.acceleration, 0.0));
    REQUIRE(quick.advance(0.1));
    CHECK_FALSE(quick.advance(0.5));  // all rods in one line
    REQUIRE(quick.advance(0.2));
    quick.write(frame.state, frame.velocity, frame.acceleration);
    CHECK((frame.state.r[2] - Vec3(std::cos(0.3), std::sin(0.3), 0.0)).norm() < 1e-13);

    const Mechanism free = test::parallelogram(0.5);
    CHECK_FALSE(DrivenFrames::can_follow(System(free, everything(free))));
    CHECK_FALSE(DrivenFrames::can_follow(System(mechanism, {{0, 1}, {0}})));
}

TEST_CASE("A crank that has turned a thousand times is followed as one in its first turn", "[core][motion]") {
    const Mechanism mechanism = test::driven(test::four_bar_at(0.4), 0, 1.0);
    const System system(mechanism, everything(mechanism));
    const double turns = 1000.0 * 2.0 * std::numbers::pi;
    DrivenFrames quick(system);
    Moment frame{start_state(mechanism), zero_motion(mechanism), zero_motion(mechanism)};
    frame = thorough(system, frame, turns);
    REQUIRE(quick.start(frame.state, frame.velocity, frame.acceleration, turns));
    Moment first{start_state(mechanism), zero_motion(mechanism), zero_motion(mechanism)};
    for (int k = 1; k <= 60; ++k) {
        const double t = 0.05 * k;
        CAPTURE(t);
        REQUIRE(quick.advance(turns + t));
        quick.write(frame.state, frame.velocity, frame.acceleration);
        first = thorough(system, first, t);
        // turns + t is rounded to 5e-13
        for (const int body : system.moving_bodies()) {
            CHECK((frame.state.r[at(body)] - first.state.r[at(body)]).norm() < 1e-11);
        }
    }
}
