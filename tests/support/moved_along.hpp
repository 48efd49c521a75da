#pragma once

#include "core/model/mechanism.hpp"

/// Mechanisms on a path of which velocity and acceleration are known, and differences along it.
namespace jw::test {

/// State after a time `t` [s] of this velocity and constant r̈, p̈ and θ̈; those of `acceleration` (ω̇') at t
/// = 0. p stays unit to second order, which is as far as differences look.
inline State moved_along(State state, const Motion& velocity, const Motion& acceleration, double t) {
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        const Vec4 p = state.p[b];
        state.r[b] += t * velocity.r_dot[b] + 0.5 * t * t * acceleration.r_dot[b];
        state.p[b] +=
            t * p_dot_of_omega_local(p, velocity.omega_local[b]) +
            0.5 * t * t * p_ddot_of_omega_local(p, velocity.omega_local[b], acceleration.omega_local[b]);
    }
    for (std::size_t k = 0; k < state.theta.size(); ++k) {
        state.theta[k] += t * velocity.theta_dot[k] + 0.5 * t * t * acceleration.theta_dot[k];
    }
    return state;
}

/// Derivatives of f at 0 by differences of order 4. For functions of size and slope 1 to 10 their error is
/// below 1e-9 and 1e-7: truncation h⁴ and rounding 1e-15/h, 1e-14/h².
inline constexpr double kRateError = 1e-9;
inline constexpr double kAccelerationError = 1e-7;

template <class F>
auto rate_by_difference(const F& f, double h = 1e-3) -> decltype(f(0.0)) {
    return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}

template <class F>
auto acceleration_by_difference(const F& f, double h = 2e-3) -> decltype(f(0.0)) {
    return (16.0 * (f(h) + f(-h)) - (f(2.0 * h) + f(-2.0 * h)) - 30.0 * f(0.0)) / (12.0 * h * h);
}

}  // namespace jw::test
