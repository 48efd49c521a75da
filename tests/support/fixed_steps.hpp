#pragma once

#include <vector>

#include "core/integrate/runge_kutta.hpp"
#include "core/motion/motion_equations.hpp"

/// Fixed steps by a Runge-Kutta table and nothing else: trajectories that owe nothing to the integrators.
namespace jw::test {

/// y after `steps` steps over `duration`; back on the constraints after each of them if `project`.
inline std::vector<double> run(
    MotionEquations& equations, const RungeKuttaTable& table, std::vector<double> y, double duration,
    int steps, bool project) {
    const double h = duration / steps;
    const auto f = [&](double t, const double* at, double* y_dot) { equations.evaluate(t, at, y_dot); };
    equations.choose_rows(0.0, y.data());
    for (int n = 0; n < steps; ++n) {
        take_step(table, f, n * h, h, y);
        if (project) { equations.project((n + 1) * h, y.data()); }
    }
    return y;
}

}  // namespace jw::test
