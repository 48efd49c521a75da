#include "app/hard/dynamic_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/hard/shipped.hpp"

namespace jw::hard {

DynamicScene shipped_scene(std::string_view name) {
    const std::optional<Reference> reference = stored_reference(name);
    if (!reference) { throw std::runtime_error("no reference for " + std::string(name)); }
    return {shipped_lesson(name), *reference};
}

Centroidal centroidal_of(const Lesson& lesson) {
    return centroidal(lesson.mechanism, lesson.dynamics->loads);
}

std::vector<double> start_of(const Centroidal& scene) {
    std::vector<int> moving;
    for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
        if (!scene.mechanism.bodies[b].fixed) { moving.push_back(static_cast<int>(b)); }
    }
    std::vector<double> y(kNumbersPerBody * moving.size());
    pack(start_state(scene.mechanism), start_motion(scene.mechanism), moving, y.data());
    return y;
}

Watch::Watch(const DynamicScene& scene)
    : scene_(&scene), simulation_(scene.lesson.mechanism, scene.lesson.dynamics->loads, {}) {}

void Watch::look_at(std::size_t k, const std::vector<double>& y) {
    const BodyPoint& tracked = *scene_->lesson.dynamics->point;
    const Vec3 at = simulation_.point(y, tracked.body, tracked.point_local);
    const Snapshot snapshot = simulation_.snapshot(scene_->reference.times[k], y);
    const double energy = snapshot.kinetic + snapshot.potential;
    if (k == 0) { energy_at_start_ = energy; }
    // what is not a number counts as infinitely far
    const double distance = (at - scene_->reference.positions[k]).norm();
    position = std::max(position, std::isfinite(distance) ? distance : HUGE_VAL);
    violation = std::max(violation, snapshot.position_violation);
    p_drift = std::max(p_drift, snapshot.p_drift);
    largest_kinetic_ = std::max(largest_kinetic_, snapshot.kinetic);
    change_ = std::max(change_, std::abs(energy - energy_at_start_));
}

Trajectory run_of(
    const DynamicScene& scene, const SimulationSettings& settings, double share, const See& see) {
    const auto& times = scene.reference.times;
    const auto count =
        static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(times.size() - 1)));
    Watch watch(scene);
    Simulation simulation(scene.lesson.mechanism, scene.lesson.dynamics->loads, settings);
    std::size_t k = 0;
    const SimulationOutcome outcome =
        simulation.run({times.begin(), times.begin() + count + 1}, [&](double, const std::vector<double>& y) {
            watch.look_at(k++, y);
            if (see) { see(y); }
        });
    return {watch.position, watch.energy(), watch.violation, outcome.counts, !outcome.failure};
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

Measurement of_both(std::string what, double naive, Bounds its, double ours, Bounds ours_bounds) {
    return {std::move(what), Bounded{naive, its}, Bounded{ours, ours_bounds}};
}
Measurement of_naive(std::string what, double value, Bounds bounds) {
    return {std::move(what), Bounded{value, bounds}, {}};
}
Measurement of_ours(std::string what, double value, Bounds bounds) {
    return {std::move(what), {}, Bounded{value, bounds}};
}

}  // namespace jw::hard
