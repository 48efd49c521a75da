#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/session/benchmark/benchmark.hpp"
#include "core/integrate/runge_kutta.hpp"
#include "tests/hard/hard_case.hpp"

/// Lessons of dynamics for the hard cases, and the errors of their trajectories.
namespace jw::hard {

struct DynamicScene {
    Lesson lesson;
    Reference reference;
};

/// @param name below lessons/catalogue; it has a stored reference
DynamicScene shipped_scene(std::string_view name);

/// Lesson as a scene for the equations of motion; its flat start is flat_start(scene.mechanism).
Centroidal centroidal_of(const Lesson& lesson);

/// Energies at a flat state.
Energy energy_at(const Centroidal& scene, const std::vector<double>& flat);

/// A run by the program's own methods.
struct Trajectory {
    double position = 0.0;
    double energy = 0.0;
    double violation = 0.0;
    IntegrationCounts counts;
    bool arrived = false;  ///< the run reached the end
};
using See = std::function<void(const std::vector<double>& y)>;
/// @param share of the reference's time
/// @param see callback, called with the flat state at every time of the reference
Trajectory run_of(
    const DynamicScene& scene, const SimulationSettings& settings, double share = 1.0, const See& see = {});

SimulationSettings adaptive(Method method, double tolerance);
SimulationSettings fixed_steps(Method method, double step, Treatment treatment);

}  // namespace jw::hard
