#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/hard/hard_case.hpp"
#include "app/session/benchmark.hpp"
#include "core/dynamics/runge_kutta.hpp"

/// Lessons of dynamics as material of the cases, and what a trajectory of theirs is worth.
namespace jw::hard {

struct DynamicScene {
    Lesson lesson;
    Reference reference;
};

/// @param name below lessons/catalogue; it has a stored reference
DynamicScene shipped_scene(std::string_view name);

/// Centroidal and flat, as the equations of motion want them.
Centroidal centroidal_of(const Lesson& lesson);
std::vector<double> start_of(const Centroidal& scene);

/// The largest errors of a trajectory so far.
class Watch {
public:
    /// `scene` must outlive this.
    explicit Watch(const DynamicScene& scene);

    /// The state at the k-th time of the reference.
    void look_at(std::size_t k, const std::vector<double>& y);

    double position = 0.0;   ///< of the lesson's point, from the reference [m]
    double violation = 0.0;  ///< |Φ| by the size of its equation
    double p_drift = 0.0;
    /// Change of energy, by the largest kinetic energy.
    double energy() const { return change_ / largest_kinetic_; }
    const Simulation& simulation() const { return simulation_; }

private:
    const DynamicScene* scene_;
    Simulation simulation_;
    double energy_at_start_ = 0.0;
    double change_ = 0.0;
    double largest_kinetic_ = 0.0;
};

/// A run by the program's own methods.
struct Trajectory {
    double position = 0.0;
    double energy = 0.0;
    double violation = 0.0;
    IntegrationCounts counts;
    bool arrived = false;  ///< at the end
};
using See = std::function<void(const std::vector<double>& y)>;
/// @param share of the reference's time
/// @param see gets the flat state at every time of the reference
Trajectory run_of(
    const DynamicScene& scene, const SimulationSettings& settings, double share = 1.0, const See& see = {});

SimulationSettings adaptive(Method method, double tolerance);
SimulationSettings fixed_steps(Method method, double step, Treatment treatment);

/// Lines of a result.
Measurement of_both(std::string what, double naive, Bounds its, double ours, Bounds ours_bounds);
Measurement of_naive(std::string what, double value, Bounds bounds = any());
Measurement of_ours(std::string what, double value, Bounds bounds = any());

/// One step of ẏ = f(t, y) by a table and nothing else. `f(t, y, y_dot)` fills y_dot.
template <class F>
void take_step(const RungeKuttaTable& table, const F& f, double t, double h, std::vector<double>& y) {
    const auto stages = static_cast<std::size_t>(table.stages);
    std::vector<std::vector<double>> k(stages, std::vector<double>(y.size()));
    const auto moved = [&](const RungeKuttaTable::Row& factors, std::size_t count) {
        std::vector<double> out = y;
        for (std::size_t m = 0; m < count; ++m) {
            for (std::size_t n = 0; n < y.size(); ++n) { out[n] += h * factors[m] * k[m][n]; }
        }
        return out;
    };
    for (std::size_t s = 0; s < stages; ++s) {
        const std::vector<double> at_stage = moved(table.a[s], s);
        f(t + table.c[s] * h, at_stage.data(), k[s].data());
    }
    y = moved(table.b, stages);
}

}  // namespace jw::hard
