#include <array>
#include <cmath>
#include <numbers>

#include "core/equations/system.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

/// The mechanism with the pairs of rows that the rule chooses at the start, kept from then on.
Mechanism with_kept_pairs(const Mechanism& mechanism) {
    System system(mechanism, everything(mechanism));
    system.choose_rows(start_state(mechanism));
    Mechanism kept = mechanism;
    for (const Constraint& c : system.constraints()) {
        if (c.dropped < 0) { continue; }
        constexpr std::array forms{ParallelForm::drop_x, ParallelForm::drop_y, ParallelForm::drop_z};
        kept.joints[static_cast<std::size_t>(c.joint)].parallel_form =
            forms[static_cast<std::size_t>(c.dropped)];
    }
    return kept;
}

/// J θ̈ = -k θ with θ taken from the pose of the disc, which gives θ only up to whole turns.
double naive_angle(double stiffness, double inertia, double omega, double duration) {
    std::vector<double> y{0.0, omega};
    const auto f = [&](double, const double* at, double* rate) {
        rate[0] = at[1];
        rate[1] = -stiffness / inertia * std::remainder(at[0], 2.0 * std::numbers::pi);
    };
    constexpr int steps = 10000;
    for (int k = 0; k < steps; ++k) { take_step(runge_kutta_4(), f, 0.0, duration / steps, y); }
    return y[0];
}

}  // namespace

Result pair_kept_while_falling() {
    DynamicScene scene = shipped_scene("dynamics/chain-revolute-4.toml");
    SimulationSettings settings = adaptive(Method::explicit_8, 1e-7);
    settings.dense = CoordinateChoice::omega_local;
    const Trajectory ours = run_of(scene, settings);
    scene.lesson.mechanism = with_kept_pairs(scene.lesson.mechanism);
    const Trajectory naive = run_of(scene, settings);

    Result result;
    result.naive =
        "every kept equation holds and energy is conserved, so nothing looks wrong; but the axes have "
        "separated, and the links fall differently.";
    result.ours = "the rule is applied after every step, and no step turns a link by more than 0.4 rad.";
    result.measurements = {
        // the chain is 4 m long; ours: some 50 steps within 1e-7 of it, and the motion magnifies errors
        of_both("free end off by [m]", naive.position, at_least(0.5), ours.position, at_most(2e-5)),
        of_both("kept equations off by", naive.violation, at_most(1e-6), ours.violation, at_most(1e-6)),
        of_both("change of energy", naive.energy, any(), ours.energy, at_most(1e-5)),
        of_both("arrives", naive.arrived ? 1.0 : 0.0, any(), ours.arrived ? 1.0 : 0.0, exactly(1)),
    };
    return result;
}

Result wound_spring() {
    const Lesson lesson = shipped_lesson("dynamics/torsion-pendulum.toml");
    const RotationalSpring& spring = lesson.dynamics->loads.rotational_springs.front();
    const double inertia = lesson.dynamics->loads.masses.back()->J_local(2, 2);
    const double omega = lesson.mechanism.bodies.back().omega_local.z();
    const double frequency = std::sqrt(spring.stiffness / inertia);
    const double duration = lesson.dynamics->duration;
    const double exact = omega / frequency * std::sin(frequency * duration);
    const double radius = lesson.dynamics->point->point_local.norm();
    const auto end_at = [&](double angle) {
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    };
    Vec3 end = Vec3::Constant(HUGE_VAL);
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, adaptive(Method::explicit_8, 1e-10));
    const SimulationOutcome outcome =
        simulation.run({0.0, duration}, [&](double, const std::vector<double>& y) {
            end = simulation.point(y, lesson.dynamics->point->body, lesson.dynamics->point->point_local);
        });
    const double naive = naive_angle(spring.stiffness, inertia, omega, duration);
    constexpr double full = 2.0 * std::numbers::pi;

    Result result;
    result.naive =
        "beyond half a turn the spring is taken to pull in the opposite direction, so the disc spins on.";
    result.ours =
        "turns are counted from step to step, and the steps are short enough for that in all coordinates.";
    result.measurements = {
        of_both(
            "mark on the rim off by [m]", (end_at(naive) - end_at(exact)).norm(), any(),
            (end - end_at(exact)).norm(), at_most(1e-8)),
        of_naive("turns from where it should be", std::abs(naive - exact) / full, at_least(1.0)),
        of_ours("reports success", outcome.failure ? 0.0 : 1.0, exactly(1)),
    };
    return result;
}

}  // namespace jw::hard
