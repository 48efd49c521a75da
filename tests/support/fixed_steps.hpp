#pragma once

#include <vector>

#include "core/dynamics/motion_equations.hpp"
#include "core/dynamics/runge_kutta.hpp"

/// Fixed steps by a Runge-Kutta table and nothing else: trajectories that owe nothing to the integrators.
namespace jw::test {

/// One step of ẏ = f(t, y). `f(t, y, y_dot)` fills y_dot.
template <class F>
void take_step(const RungeKuttaTable& table, const F& f, double t, double h, std::vector<double>& y) {
    const auto stages = static_cast<std::size_t>(table.stages);
    std::vector<std::vector<double>> k(stages, std::vector<double>(y.size()));
    std::vector<double> at_stage;
    const auto moved = [&](const RungeKuttaTable::Row& factors, std::size_t count) {
        std::vector<double> out = y;
        for (std::size_t m = 0; m < count; ++m) {
            for (std::size_t n = 0; n < y.size(); ++n) { out[n] += h * factors[m] * k[m][n]; }
        }
        return out;
    };
    for (std::size_t s = 0; s < stages; ++s) {
        at_stage = moved(table.a[s], s);
        f(t + table.c[s] * h, at_stage.data(), k[s].data());
    }
    y = moved(table.b, stages);
}

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
