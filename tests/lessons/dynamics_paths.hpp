#pragma once

#include <algorithm>
#include <vector>

#include "core/integrate/simulation.hpp"
#include "lessons/lesson/lesson.hpp"

/// Trajectories of lessons by every way of integrating them.
namespace jw::test {

/// Explicit in joints and in bodies, implicit, and the dense equations in all four choices.
inline std::vector<SimulationSettings> all_ways(double tolerance) {
    SimulationSettings settings;
    settings.tolerance = tolerance;
    std::vector<SimulationSettings> ways;
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        settings.formulation = formulation;
        ways.push_back(settings);
    }
    for (const Method method : {Method::implicit_5, Method::implicit_9}) {
        settings.formulation = Formulation::automatic;
        settings.method = method;
        ways.push_back(settings);
    }
    settings.method = Method::explicit_8;
    for (const CoordinateChoice choice :
         {CoordinateChoice::omega_local, CoordinateChoice::omega_global,
          CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters}) {
        settings.dense = choice;
        ways.push_back(settings);
    }
    return ways;
}

/// Flat states at the times, and the sums of energies.
struct Path {
    std::vector<std::vector<double>> states;
    std::vector<double> energies;
    double violation = 0.0;  ///< largest |Φ|, by the size of its equation
    bool failed = false;
    SimulationFailure failure;  ///< if it failed
};
inline Path path_of(
    const Lesson& lesson, const SimulationSettings& settings, const std::vector<double>& times) {
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    Path path;
    const auto outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
        path.states.push_back(y);
        const Snapshot snapshot = simulation.snapshot(t, y);
        path.energies.push_back(snapshot.kinetic + snapshot.potential);
        path.violation = std::max(path.violation, snapshot.position_violation);
    });
    path.failed = outcome.failure.has_value();
    if (path.failed) { path.failure = *outcome.failure; }
    return path;
}

/// Positions of the lesson's point in the states.
inline std::vector<Vec3> points_of(const Lesson& lesson, const Path& path) {
    const Simulation simulation(lesson.mechanism, lesson.dynamics->loads, {});
    std::vector<Vec3> points;
    for (const std::vector<double>& y : path.states) {
        points.push_back(
            simulation.point(y, lesson.dynamics->point->body, lesson.dynamics->point->point_local));
    }
    return points;
}

/// @return `count` + 1 equal times from 0 to `end`
inline std::vector<double> times_until(double end, int count) {
    std::vector<double> times;
    for (int k = 0; k <= count; ++k) { times.push_back(end * k / count); }
    return times;
}

}  // namespace jw::test
