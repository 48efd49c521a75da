#include "tests/hard/dynamic_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lessons/files/catalogue.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

DynamicScene shipped_scene(std::string_view name) {
    const std::optional<Reference> reference = stored_reference(catalogue_folder() / name);
    if (!reference) { throw std::runtime_error("no reference for " + std::string(name)); }
    return {shipped_lesson(name), *reference};
}

Centroidal centroidal_of(const Lesson& lesson) {
    return centroidal(lesson.mechanism, lesson.dynamics->loads);
}

Energy energy_at(const Centroidal& scene, const std::vector<double>& flat) {
    State state = start_state(scene.mechanism);
    Motion motion = start_motion(scene.mechanism);
    unpack(flat.data(), moving_bodies_of(scene.mechanism), state, motion);
    return energy_of(scene, state, motion);
}

Trajectory run_of(
    const DynamicScene& scene, const SimulationSettings& settings, double share, const See& see) {
    const auto& times = scene.reference.times;
    const auto count =
        static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(times.size() - 1)));
    TrajectoryErrors errors(scene.lesson, scene.reference);
    Simulation simulation(scene.lesson.mechanism, scene.lesson.dynamics->loads, settings);
    std::size_t k = 0;
    const SimulationOutcome outcome =
        simulation.run({times.begin(), times.begin() + count + 1}, [&](double, const std::vector<double>& y) {
            errors.look_at(k++, y);
            if (see) { see(y); }
        });
    return {errors.position(), errors.energy(), errors.violation(), outcome.counts, !outcome.failure};
}

SimulationSettings adaptive(Method method, double tolerance) {
    SimulationSettings settings;
    settings.method = method;
    settings.tolerance = tolerance;
    return settings;
}

SimulationSettings fixed_steps(Method method, double step, Treatment treatment) {
    SimulationSettings settings;
    settings.method = method;
    settings.step = step;
    settings.treatment = treatment;
    return settings;
}

}  // namespace jw::hard
