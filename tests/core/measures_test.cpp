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
