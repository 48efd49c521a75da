#pragma once

#include <cmath>
#include <numbers>
#include <variant>

#include "core/jets/primitives.hpp"
#include "core/jets/time_function.hpp"
#include "core/numerics/variants.hpp"

/// Measures of a mechanism (an angle, a displacement, ...) and drivers that prescribe them.
namespace jw {

/// Right-handed angle from u_i to u_j about s_i, in (-π, π] [rad].
struct AngleMeasure {
    Vec3 s_i_local;  ///< unit
    Vec3 u_i_local;  ///< unit, perpendicular to s_i
    Vec3 u_j_local;  ///< unit
};

/// Signed displacement s_iᵀ d along a unit axis [m]; smooth through d = 0.
struct DisplacementMeasure {
    Vec3 s_i_local;  ///< unit
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]
};

/// Squared distance dᵀd between two points [m²]; squared, because |d| has no derivative at d = 0.
struct SquaredDistanceMeasure {
    Vec3 P_i_local;  ///< [m]
    Vec3 P_j_local;  ///< [m]
};

/// One coordinate of body j: 0..2 = x, y, z [m], 3..6 = e0..e3.
struct CoordinateMeasure {
    int coordinate = 0;
};

/// Artificial coordinate θ of a joint, turns included [rad].
struct ThetaMeasure {};

using Measure =
    std::variant<AngleMeasure, DisplacementMeasure, SquaredDistanceMeasure, CoordinateMeasure, ThetaMeasure>;

template <Content K, class C>
auto measured(
    const AngleMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    const auto u_i = arm<K, kBodyI>(i, m.u_i_local);
    const auto u_j = arm<K, kBodyJ>(j, m.u_j_local);
    return atan2(dot(cross(u_i, u_j), arm<K, kBodyI>(i, m.s_i_local)), dot(u_i, u_j));
}

template <Content K, class C>
auto measured(
    const DisplacementMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    return dot(arm<K, kBodyI>(i, m.s_i_local), vector_between<K>(i, m.B_i_local, j, m.B_j_local));
}

template <Content K, class C>
auto measured(
    const SquaredDistanceMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    return squared_distance<K>(i, m.P_i_local, j, m.P_j_local);
}

template <Content K, class C>
auto measured(
    const CoordinateMeasure& m, const BodyKinematics<C>& /*i*/, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    return m.coordinate >= 3 ? component(parameters<K, kBodyJ>(j), m.coordinate - 3)
                             : component(point<K, kBodyJ>(j, Vec3::Zero()), m.coordinate);
}

template <Content K, class C>
auto measured(
    const ThetaMeasure& /*m*/, const BodyKinematics<C>& /*i*/, const BodyKinematics<C>& /*j*/,
    const ThetaOf<C>& theta) {
    return artificial<C, K>(theta);
}

/// Size of a measure's gradient when unknowns are measured in units of `length` [m].
inline double unit_of(const Measure& measure, double length) {
    return std::visit(
        Overloaded{
            [](const AngleMeasure&) { return 1.0; },
            [&](const DisplacementMeasure&) { return length; },
            [&](const SquaredDistanceMeasure&) { return length * length; },
            [&](const CoordinateMeasure& m) { return m.coordinate < 3 ? length : 1.0; },
            [](const ThetaMeasure&) { return 1.0; },
        },
        measure);
}

/// Target of a driver's measure at a time: the time function itself, or its square for a squared distance.
inline TimeFunction::Value target_of(const Measure& measure, const TimeFunction& function, double t) {
    const TimeFunction::Value f = function.at(t);
    if (!std::holds_alternative<SquaredDistanceMeasure>(measure)) { return f; }
    return {f.f * f.f, 2.0 * f.f * f.f_dot, 2.0 * (f.f_dot * f.f_dot + f.f * f.f_ddot)};
}

/// Φ of a driver: measure minus target. An angle is compared modulo a turn, so that the same pose satisfies
/// the equation for every number of turns, and there is no false solution half a turn away.
inline double driver_residual(const Measure& measure, double measured_value, double target) {
    if (!std::holds_alternative<AngleMeasure>(measure)) { return measured_value - target; }
    constexpr double turn = 2.0 * std::numbers::pi;
    // the target alone is reduced exactly; a difference of many turns would round
    const double within = std::abs(target) > std::numbers::pi ? std::remainder(target, turn) : target;
    return std::remainder(measured_value - within, turn);
}

}  // namespace jw
