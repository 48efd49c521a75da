#pragma once

#include "core/equations/assembler.hpp"
#include "core/jets/euler_parameters.hpp"
#include "tests/support/reference_phi.hpp"

/// Positions along a motion in long double, for differences of the reference Φ.
namespace jw::test {

inline reference::Positions positions_of(const State& state) {
    using reference::Real;
    reference::Positions q;
    for (const Vec3& r : state.r) { q.r.push_back(r.cast<Real>()); }
    for (const Vec4& p : state.p) { q.p.push_back(p.cast<Real>()); }
    for (const double theta : state.theta) { q.theta.push_back(theta); }
    return q;
}

/// q(t) = q + q̇ t + q̈ t²/2 for velocities and accelerations given as columns of the choice C.
template <class C>
reference::Positions moved(
    const System& system, const State& state, const VectorX& v, const VectorX& a, reference::Real t) {
    using reference::Real;
    reference::Positions q = positions_of(state);
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        const int column = system.body_column(body, C::kAngular);
        q.r[b] += t * v.segment<3>(column).cast<Real>() + t * t / 2 * a.segment<3>(column).cast<Real>();
        Vec4 p_dot;
        Vec4 p_ddot;
        if constexpr (C::kNormalised) {
            p_dot = v.segment<4>(column + 3);
            p_ddot = a.segment<4>(column + 3);
        } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
            p_dot = p_dot_of_omega_global(state.p[b], v.segment<3>(column + 3));
            p_ddot = p_ddot_of_omega_global(state.p[b], v.segment<3>(column + 3), a.segment<3>(column + 3));
        } else {
            p_dot = p_dot_of_omega_local(state.p[b], v.segment<3>(column + 3));
            p_ddot = p_ddot_of_omega_local(state.p[b], v.segment<3>(column + 3), a.segment<3>(column + 3));
        }
        q.p[b] += t * p_dot.cast<Real>() + t * t / 2 * p_ddot.cast<Real>();
    }
    for (const int theta : system.active_thetas()) {
        const int column = system.theta_column(theta, C::kAngular);
        q.theta[static_cast<std::size_t>(theta)] += t * Real(v(column)) + t * t / 2 * Real(a(column));
    }
    return q;
}

/// Derivative of f at 0 by central differences of order 4 with step h.
template <class F>
reference::VX first_difference_of(const F& f, reference::Real h) {
    return reference::VX((8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h));
}

}  // namespace jw::test
