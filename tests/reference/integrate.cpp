#include <algorithm>
#include <array>
#include <stdexcept>

#include "tests/reference/ode.hpp"

namespace jw::reference {

namespace {

/// One attempt: the new y and the error of the step relative to 1 + |y|.
struct Attempt {
    VecX y;
    Real error = 0.0L;
};

Real relative_error(const VecX& error, const VecX& y) {
    Real most = 0.0L;
    for (Eigen::Index k = 0; k < y.size(); ++k) {
        const Real e = std::abs(error[k]) / (1.0L + std::abs(y[k]));
        if (!(e <= most)) { most = e; }
    }
    return std::isfinite(most) ? most : HUGE_VALL;
}

// Fehlberg: Classical fifth-, sixth-, seventh-, and eighth-order Runge-Kutta formulas. NASA TR R-287 (1968)
using Row = std::array<Real, 12>;
constexpr std::array<Row, 13> kFehlberg{{
    {},
    {2.0L / 27},
    {1.0L / 36, 1.0L / 12},
    {1.0L / 24, 0, 1.0L / 8},
    {5.0L / 12, 0, -25.0L / 16, 25.0L / 16},
    {1.0L / 20, 0, 0, 1.0L / 4, 1.0L / 5},
    {-25.0L / 108, 0, 0, 125.0L / 108, -65.0L / 27, 125.0L / 54},
    {31.0L / 300, 0, 0, 0, 61.0L / 225, -2.0L / 9, 13.0L / 900},
    {2, 0, 0, -53.0L / 6, 704.0L / 45, -107.0L / 9, 67.0L / 90, 3},
    {-91.0L / 108, 0, 0, 23.0L / 108, -976.0L / 135, 311.0L / 54, -19.0L / 60, 17.0L / 6, -1.0L / 12},
    {2383.0L / 4100, 0, 0, -341.0L / 164, 4496.0L / 1025, -301.0L / 82, 2133.0L / 4100, 45.0L / 82,
     45.0L / 164, 18.0L / 41},
    {3.0L / 205, 0, 0, 0, 0, -6.0L / 41, -3.0L / 205, -3.0L / 41, 3.0L / 41, 6.0L / 41},
    {-1777.0L / 4100, 0, 0, -341.0L / 164, 4496.0L / 1025, -289.0L / 82, 2193.0L / 4100, 51.0L / 82,
     33.0L / 164, 12.0L / 41, 0, 1},
}};
constexpr std::array<Real, 13> kEighthOrder{
    0, 0, 0, 0, 0, 34.0L / 105, 9.0L / 35, 9.0L / 35, 9.0L / 280, 9.0L / 280, 0, 41.0L / 840, 41.0L / 840};

Attempt fehlberg_step(Ode& ode, const VecX& y, const VecX& y_dot, Real h) {
    std::array<VecX, 13> k;
    k[0] = y_dot;
    for (std::size_t s = 1; s < 13; ++s) {
        VecX sum = VecX::Zero(y.size());
        for (std::size_t m = 0; m < s; ++m) {
            if (kFehlberg[s][m] != 0.0L) { sum += kFehlberg[s][m] * k[m]; }
        }
        ode.derivative(y + h * sum, k[s]);
    }
    VecX sum = VecX::Zero(y.size());
    for (std::size_t s = 0; s < 13; ++s) { sum += kEighthOrder[s] * k[s]; }
    const VecX error = h * (41.0L / 840) * (k[0] + k[10] - k[11] - k[12]);
    return {y + h * sum, relative_error(error, y)};
}

/// Change of y over `steps` steps (an even number) of the modified midpoint rule; the error has even powers
/// of the step only. Changes are summed up, not y itself: they are smaller, and so is their rounding.
VecX midpoint_rule(Ode& ode, const VecX& y, const VecX& y_dot, Real h, int steps) {
    const Real small = h / static_cast<Real>(steps);
    VecX before = VecX::Zero(y.size());
    VecX now = small * y_dot;
    VecX slope;
    for (int s = 1; s < steps; ++s) {
        ode.derivative(y + now, slope);
        before += 2.0L * small * slope;
        before.swap(now);
    }
    return now;
}

/// Polynomial extrapolation of 2, 6, 10 ... 26 small steps to a step of length 0 (Neville). Numbers that grow
/// this fast keep the weights, and with them the rounding, a third of those of 2, 4, 6 ...
Attempt extrapolation_step(Ode& ode, const VecX& y, const VecX& y_dot, Real h) {
    constexpr std::size_t kColumns = 7;
    const auto steps = [](std::size_t k) { return static_cast<int>(4 * k + 2); };
    std::array<VecX, kColumns> row;
    VecX error;
    for (std::size_t k = 0; k < kColumns; ++k) {
        VecX value = midpoint_rule(ode, y, y_dot, h, steps(k));
        for (std::size_t m = 1; m <= k; ++m) {
            const Real ratio = static_cast<Real>(steps(k)) / static_cast<Real>(steps(k - m));
            error = (value - row[m - 1]) / (ratio * ratio - 1.0L);
            row[m - 1] = value;
            value += error;
        }
        row[k] = value;
    }
    return {y + row[kColumns - 1], relative_error(error, y)};
}

}  // namespace

void integrate(
    Ode& ode, const std::vector<Real>& times, Method method, Real tolerance, const Receive& receive,
    long most_steps) {
    const bool fehlberg = method == Method::runge_kutta_fehlberg;
    const Real exponent = fehlberg ? 1.0L / 8 : 1.0L / 13;
    const Real duration = times.back() - times.front();
    VecX y = ode.start();
    VecX y_dot;
    ode.begin_step(y);
    ode.project(y);
    receive(y);
    Real h = 1e-5L * duration;
    long steps = 0;
    for (std::size_t k = 1; k < times.size(); ++k) {
        Real left = times[k] - times[k - 1];
        while (left > 0.0L) {
            if (++steps > most_steps) { throw std::runtime_error("too many steps"); }
            ode.begin_step(y);
            ode.derivative(y, y_dot);
            const bool last = h >= left;
            const Real tried = last ? left : std::min(h, left / 2.0L);
            Attempt attempt =
                fehlberg ? fehlberg_step(ode, y, y_dot, tried) : extrapolation_step(ode, y, y_dot, tried);
            const Real ratio = std::max(attempt.error / tolerance, 1e-20L);
            const Real next = tried * std::clamp(0.8L * std::pow(ratio, -exponent), 0.2L, 4.0L);
            if (ratio > 1.0L) {
                h = next;
                if (h < 1e-12L * duration) { throw std::runtime_error("step too small"); }
                continue;
            }
            h = last ? std::max(h, next) : next;
            left = last ? 0.0L : left - tried;
            y = attempt.y;
            ode.project(y);
        }
        receive(y);
    }
}

Trajectory integrate(Ode& ode, Real duration, Method method, Real tolerance) {
    std::vector<Real> times;
    for (int k = 0; k <= kIntervals; ++k) { times.push_back(duration / kIntervals * k); }
    Trajectory trajectory;
    integrate(ode, times, method, tolerance, [&](const VecX& y) { trajectory.push_back(ode.sample(y)); });
    return trajectory;
}

}  // namespace jw::reference
