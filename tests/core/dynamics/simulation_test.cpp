#include <catch2/catch.hpp>

#include "core/dynamics/simulation.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

/// A parallelogram whose last axis is tilted in one of its bodies [rad].
Mechanism tilted_four_bar(double tilt) {
    Mechanism mechanism = test::four_bar_at(0.9);
    Vec3& axis = mechanism.joints.back().geometry.s_j_local;
    axis = rotation_matrix(euler_parameters_of(perpendicular_to(axis), tilt)) * axis;
    return mechanism;
}

Loads loads_of(const Mechanism& mechanism) {
    test::Random random(3);
    return test::random_conservative_loads(random, mechanism);
}

SimulationOutcome outcome_of(const Mechanism& mechanism, int& received) {
    Simulation simulation(mechanism, loads_of(mechanism), {});
    return simulation.run({0.0, 0.05}, [&](double, const std::vector<double>&) { ++received; });
}

}  // namespace

TEST_CASE("A loop with a tilted axis is refused at the start, and the joint is named", "[core][dynamics]") {
    for (const double tilt : {0.1, 1e-4}) {
        const Mechanism mechanism = tilted_four_bar(tilt);
        int received = 0;
        const SimulationOutcome outcome = outcome_of(mechanism, received);
        REQUIRE(outcome.failure);
        CHECK(outcome.failure->cause == SimulationFailure::Cause::contradiction);
        CHECK(received == 0);
        const auto names_it = [&](const Joint& joint) { return joint.name == outcome.failure->equation_of; };
        CHECK(std::ranges::any_of(mechanism.joints, names_it));
        // the tilt, as much of it as the loop leaves to one equation
        CHECK(outcome.failure->violation > 0.1 * tilt);
        CHECK(outcome.failure->violation < 2.0 * tilt);
    }
}

TEST_CASE("A loop that closes to its typed digits only is no contradiction", "[core][dynamics]") {
    int received = 0;
    CHECK_FALSE(outcome_of(tilted_four_bar(1e-7), received).failure);
    CHECK(received == 2);
}
