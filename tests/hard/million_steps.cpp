#include <cmath>

#include "core/integrate/explicit_integrator.hpp"
#include "core/integrate/semi_implicit.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

constexpr long kSteps = 1'000'000;

/// Invariants of a free body.
struct Kept {
    double p = 1.0;                ///< |p|
    double energy = 0.0;           ///< [J]
    Vec3 momentum = Vec3::Zero();  ///< angular, global [kg m²/s]
};

Kept kept_at(const Centroidal& scene, const Mat3& J, const std::vector<double>& y) {
    const Vec4 p = vec4(y.data() + 3);
    return {
        p.norm(), energy_at(scene, y).kinetic, rotation_matrix(p.normalized()) * (J * vec3(y.data() + 10))};
}

struct Drift {
    double p = 0.0;
    double energy = 0.0;    ///< by the energy
    double momentum = 0.0;  ///< by its size
};

double or_infinite(double value) { return std::isfinite(value) ? value : HUGE_VAL; }

/// After a million steps. `normalise`: p back to unit length after every step.
template <class Stepper, class... Table>
Drift drift_of(double step, bool normalise, const Table&... table) {
    const Lesson lesson = shipped_lesson("dynamics/free-asymmetric-body.toml");
    const Centroidal scene = centroidal_of(lesson);
    const Mat3 J = scene.loads.masses.back()->J_local;
    const auto equations = block_equations(scene);
    IntegrationOptions options;
    options.fixed_step = step;
    options.project = normalise;
    Stepper stepper(*equations, table..., options, 0.0, flat_start(scene.mechanism));
    const Kept start = kept_at(scene, J, stepper.y());
    const double far = 2.0 * step * double(kSteps);
    for (long k = 0; k < kSteps && stepper.step(far); ++k) {}
    const Kept end = kept_at(scene, J, stepper.y());
    return {
        or_infinite(std::abs(end.p - start.p)), or_infinite(std::abs(end.energy / start.energy - 1.0)),
        or_infinite((end.momentum - start.momentum).norm() / start.momentum.norm())};
}

}  // namespace

Result million_steps_of_a_free_body() {
    const double fine = 1e-4;    // for methods of first order: 100 turns in 10000 steps each
    const double coarse = 1e-2;  // for the others: 10000 turns in 100 steps each
    const Drift euler = drift_of<ExplicitIntegrator>(fine, false, explicit_euler());
    const Drift euler_unit = drift_of<ExplicitIntegrator>(fine, true, explicit_euler());
    const Drift semi = drift_of<SemiImplicitEuler>(fine, true);
    const Drift rk4 = drift_of<ExplicitIntegrator>(coarse, false, runge_kutta_4());
    const Drift rk4_unit = drift_of<ExplicitIntegrator>(coarse, true, runge_kutta_4());
    const Drift order_8 = drift_of<ExplicitIntegrator>(coarse, true, dormand_prince_853());

    Result result;
    result.naive = "|p| drifts by the error of the method, and bodies are drawn too large or too small.";
    result.ours =
        "|p| = 1 up to rounding with every method; energy and momentum show how good the method itself is.";
    // one normalisation is right to 1e-16; without it the error of the method adds up a million times
    const Bounds rounding = at_most(1e-14);
    result.measurements = {
        of_both("euler, steps of 0.1 ms: |p| - 1", euler.p, at_least(1e-2), euler_unit.p, rounding),
        of_both("euler: energy", euler.energy, any(), euler_unit.energy, any()),
        of_both("euler: angular momentum", euler.momentum, any(), euler_unit.momentum, any()),
        of_ours("semi-implicit, 0.1 ms: |p| - 1", semi.p, rounding),
        of_ours("semi-implicit: energy", semi.energy),
        of_ours("semi-implicit: angular momentum", semi.momentum),
        of_both("rk4, 10 ms: |p| - 1", rk4.p, at_least(1e-9), rk4_unit.p, rounding),
        // (h ω)^5 a step, times a million
        of_both("rk4: energy", rk4.energy, any(), rk4_unit.energy, at_most(1e-2)),
        of_both("rk4: angular momentum", rk4.momentum, any(), rk4_unit.momentum, at_most(1e-2)),
        of_ours("explicit-8, 10 ms: |p| - 1", order_8.p, rounding),
        // rounding of a million steps
        of_ours("explicit-8: energy", order_8.energy, at_most(1e-10)),
        of_ours("explicit-8: angular momentum", order_8.momentum, at_most(1e-10)),
    };
    return result;
}

}  // namespace jw::hard
