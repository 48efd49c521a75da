#include <cmath>

#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"

namespace jw::hard {

namespace {

/// Explicit Euler; after every step all velocities are scaled so that the energy is that of the start.
void euler_with_corrected_energy(const DynamicScene& scene, double step, TrajectoryErrors& errors) {
    const Centroidal centroidal = centroidal_of(scene.lesson);
    const auto equations = block_equations(centroidal);
    std::vector<double> y = flat_start(centroidal.mechanism);
    std::vector<double> y_dot(y.size());
    equations->choose_rows(0.0, y.data());
    equations->project(0.0, y.data());
    const Energy at_start = energy_at(centroidal, y);
    const double energy = at_start.kinetic + at_start.potential;
    const auto per_sample = std::lround(scene.reference.times[1] / step);
    errors.look_at(0, y);
    for (std::size_t k = 1; k < scene.reference.times.size(); ++k) {
        for (long n = 0; n < per_sample; ++n) {
            equations->evaluate(0.0, y.data(), y_dot.data());
            for (std::size_t m = 0; m < y.size(); ++m) { y[m] += step * y_dot[m]; }
            equations->project(0.0, y.data());
            const Energy now = energy_at(centroidal, y);
            const double factor = std::sqrt(std::max(energy - now.potential, 0.0) / now.kinetic);
            for (std::size_t m = 0; m < y.size(); ++m) {
                if (m % kNumbersPerBody >= 7) { y[m] *= factor; }
            }
        }
        errors.look_at(k, y);
    }
}

}  // namespace

Result energy_is_not_accuracy() {
    const DynamicScene scene = shipped_scene("dynamics/chain-spherical-4.toml");
    TrajectoryErrors naive(scene.lesson, scene.reference);
    euler_with_corrected_energy(scene, 0.02, naive);
    const Trajectory coarse = run_of(scene, adaptive(Method::explicit_8, 1e-3));
    const Trajectory fine = run_of(scene, adaptive(Method::explicit_8, 1e-9));
    Result result;
    result.naive =
        "the energy is right up to rounding because it was corrected, but the chain is at a completely "
        "different place.";
    result.ours = "both errors are shown separately.";
    // naive: an energy right to rounding, but a position off by metres; ours: a hundred times the tolerance
    result.measurements = {
        of_both(
            "change of energy, by the kinetic energy", naive.energy(), at_most(1e-12), fine.energy,
            at_most(1e-8)),
        of_both("position error in 2 s [m]", naive.position(), at_least(1.0), fine.position, at_most(1e-7)),
        of_ours("tolerance 1e-3: change of energy", coarse.energy),
        of_ours("tolerance 1e-3: position error [m]", coarse.position, at_most(1e-1)),
    };
    return result;
}

}  // namespace jw::hard
