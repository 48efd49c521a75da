#include <algorithm>
#include <cmath>

#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

/// The last axis of the four-bar, tilted by 5 degrees in one of its bodies.
Result loop_with_a_tilted_axis() {
    Lesson lesson = shipped_lesson("dynamics/four-bar-1.toml");
    const double tilt = 5.0 * kDegree;
    lesson.mechanism.joints.back().geometry.s_j_local = Vec3(0.0, std::sin(tilt), std::cos(tilt));

    const Centroidal scene = centroidal_of(lesson);
    const auto equations = block_equations(scene);
    std::vector<double> y = flat_start(scene.mechanism);
    equations->choose_rows(0.0, y.data());
    const auto f = [&](double t, const double* at, double* y_dot) { equations->evaluate(t, at, y_dot); };
    constexpr int steps = 1000;
    for (int k = 0; k < steps; ++k) {
        take_step(runge_kutta_4(), f, double(k) / steps, 1.0 / steps, y);
        equations->project(double(k + 1) / steps, y.data());
    }
    const bool arrived = std::ranges::all_of(y, [](double x) { return std::isfinite(x); });

    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, {});
    int states = 0;
    const SimulationOutcome outcome =
        simulation.run({0.0, 1.0}, [&](double, const std::vector<double>&) { ++states; });
    const bool contradiction =
        outcome.failure && outcome.failure->cause == SimulationFailure::Cause::contradiction;

    Result result;
    result.naive =
        "redundant rows are left out unchecked. The run reaches its end as if it were right, with a pin that "
        "is not closed.";
    result.ours = contradiction
                      ? "nothing is simulated: \"" +
                            failure_text(*outcome.failure, SimulationSettings{}, lesson.mechanism) + "\"."
                      : "it is simulated.";
    result.measurements = {
        of_both("reports success", arrived, exactly(1), outcome.failure ? 0.0 : 1.0, exactly(0)),
        of_naive("largest |Φ| at the end", equations->violation(1.0, y.data()).first, at_least(1e-2)),
        of_ours("names the contradiction", contradiction, exactly(1)),
        of_ours("states given out", states, exactly(0)),
    };
    return result;
}

}  // namespace jw::hard
