#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "tests/support/moved_along.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

Motion random_motion(test::Random& random, const Mechanism& mechanism) {
    Motion motion = zero_motion(mechanism);
    for (Vec3& r_dot : motion.r_dot) { r_dot = random.vector(); }
    for (Vec3& omega_local : motion.omega_local) { omega_local = random.vector(2.0); }
    for (double& theta_dot : motion.theta_dot) { theta_dot = random.number(); }
    return motion;
}

/// The measure where all lengths are `factor` times as large.
Measure enlarged(Measure measure, double factor) {
    if (auto* displacement = std::get_if<DisplacementMeasure>(&measure)) {
        displacement->B_i_local *= factor;
        displacement->B_j_local *= factor;
    } else if (auto* distance = std::get_if<SquaredDistanceMeasure>(&measure)) {
        distance->P_i_local *= factor;
        distance->P_j_local *= factor;
    }
    return measure;
}

}  // namespace

TEST_CASE("Rate and acceleration of every measure are differences of its value", "[core][measures]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        const Mechanism mechanism = test::random_drivers(random);
        const State state = start_state(mechanism);
        const Motion velocity = random_motion(random, mechanism);
        const Motion acceleration = random_motion(random, mechanism);
        for (const Driver& driver : mechanism.drivers) {
            CAPTURE(seed, driver.measure.index());
            const int theta = driver.joint;  // the screw is joint 0 and has θ 0
            const auto measured_at = [&](const State& at) {
                return evaluate_measure(
                    driver.measure, driver.body_i, driver.body_j, theta, at, velocity, acceleration);
            };
            const auto value = [&](double t) {
                return measured_at(test::moved_along(state, velocity, acceleration, t)).value;
            };
            const Measured measured = measured_at(state);
            CHECK(std::abs(measured.rate - test::rate_by_difference(value)) < 10.0 * test::kRateError);
            CHECK(
                std::abs(measured.acceleration - test::acceleration_by_difference(value)) <
                10.0 * test::kAccelerationError);
        }
    }
}

TEST_CASE("A measure grows with all lengths as its unit does", "[core][measures]") {
    constexpr double kFactor = 3.0;
    test::Random random(7);
    Mechanism mechanism = test::random_drivers(random);
    const State state = start_state(mechanism);
    for (Body& body : mechanism.bodies) { body.r *= kFactor; }
    State larger = start_state(mechanism);
    larger.theta = state.theta;
    const Motion rest = zero_motion(mechanism);
    for (const Driver& driver : mechanism.drivers) {
        CAPTURE(driver.measure.index());
        const auto value = [&](const Measure& measure, const State& at) {
            return evaluate_measure(measure, driver.body_i, driver.body_j, driver.joint, at, rest, rest)
                .value;
        };
        const double before = value(driver.measure, state);
        const double after = value(enlarged(driver.measure, kFactor), larger);
        CHECK(after == Approx(before * unit_of(driver.measure, kFactor)));
    }
}
