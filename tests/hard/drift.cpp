#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

struct LongRun {
    double violation = 0.0;
    double energy = 0.0;  ///< change, relative to the energy of the fall
};

/// rk4 with steps of 20 ms for 200 s: some 90 swings.
LongRun long_run(const Lesson& lesson, Treatment treatment, double alpha) {
    SimulationSettings settings = fixed_steps(Method::rk4, 0.02, treatment);
    settings.baumgarte = alpha;
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    LongRun out;
    double start = 0.0;
    const SimulationOutcome outcome =
        simulation.run(equal_times(200.0, 100), [&](double t, const std::vector<double>& y) {
            const Snapshot s = simulation.snapshot(t, y);
            const double energy = s.kinetic + s.potential;
            if (t == 0.0) { start = energy; }
            out.violation = std::max(out.violation, s.position_violation);
            out.energy = std::max(out.energy, std::abs(energy - start) / 9.81);
        });
    if (outcome.failure) { out.violation = out.energy = HUGE_VAL; }
    return out;
}

}  // namespace

Result drift_off_the_constraints() {
    const Lesson lesson = shipped_lesson("dynamics/simple-pendulum.toml");
    const LongRun none = long_run(lesson, Treatment::none, 0.0);
    const LongRun soft = long_run(lesson, Treatment::baumgarte, 20.0);
    const LongRun hard = long_run(lesson, Treatment::baumgarte, 200.0);
    const LongRun projected = long_run(lesson, Treatment::projection, 0.0);

    Result result;
    result.naive =
        "with Φq q̈ = γ alone, the pin moves further and further off. Baumgarte's terms keep it close, but α "
        "is a guess: if it is ten times as large, steps of 20 ms are too long and the solution diverges.";
    result.ours =
        "after every step the state is projected onto Φ = 0 and Φ̇ = 0, to the nearest point in the metric of "
        "M. There is no parameter to choose.";
    result.measurements = {
        // 1 m is the length of the pendulum
        of_both("pin off by, none [m]", none.violation, at_least(1e-2), projected.violation, at_most(1e-13)),
        of_naive("pin off by, Baumgarte, α = 20 / s [m]", soft.violation, at_least(1e-9)),
        of_naive("pin off by, Baumgarte, α = 200 / s [m]", hard.violation, at_least(1.0)),
        // rk4 loses (h ω)^5 a step
        of_both("change of energy, none", none.energy, any(), projected.energy, at_most(1e-3)),
        of_naive("change of energy, Baumgarte, α = 20 / s", soft.energy),
    };
    return result;
}

}  // namespace jw::hard
