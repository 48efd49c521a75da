#pragma once

#include <string_view>

#include "core/jets/curve.hpp"
#include "core/jets/vector_jet.hpp"

/// Primitives with an artificial coordinate that is more than the angle of a joint: wheels that roll on each
/// other, and points on curves. Each is its data and one line, as in primitives.hpp.
namespace jw {

/// Line from which the angle of a wheel is measured. It is determined by the two bodies alone, so that a gear
/// needs no third body that carries its wheels.
enum class WheelLine {
    centres,  ///< d, from centre to centre: parallel axes
    normal,   ///< s_i x s_j, the common normal of axes that are not parallel
    rack,     ///< s_i, the direction of a rack
};
constexpr std::string_view name_of(WheelLine line) {
    return line == WheelLine::centres ? "centres" : line == WheelLine::normal ? "normal" : "rack";
}

/// Wheel of a gear, a belt or a rack: ratio θ is its right-handed angle about its axis s, from the line e to
/// its vector u.
///
///   Φ = (e x u)ᵀ s cos(ratio θ) - eᵀ u sin(ratio θ)               (1 equation; m for the line of centres)
///
/// Two wheels with the same θ roll on each other, whatever carries them: for parallel axes this is the gear
/// of Haug, Computer Aided Kinematics and Dynamics, 3.3, with the artificial coordinate of slide 11, which
/// counts turns. Singular where e is parallel to s.
/// @source slide 11
struct Wheel {
    static constexpr int kEquations = 1;
    WheelLine line;
    bool of_j;       ///< wheel of body j, otherwise of body i; a rack has a wheel in j
    Vec3 s_i_local;  ///< unit; axis of the wheel of i, or direction of the rack
    Vec3 s_j_local;  ///< unit
    Vec3 u_local;    ///< unit, in the body of the wheel, perpendicular to its axis
    Vec3 P_i_local;  ///< centre of the wheel of i [m]
    Vec3 P_j_local;  ///< [m]
    double ratio;    ///< turns of this wheel in one turn of θ

    double unit(double length) const { return line == WheelLine::centres ? length : 1.0; }
    template <class F>
    void for_each_field(F&& f) const {
        f("line", line);
        f("of_j", of_j);
        f("s_i_local", s_i_local);
        f("s_j_local", s_j_local);
        f("u_local", u_local);
        f("P_i_local", P_i_local);
        f("P_j_local", P_j_local);
        f("ratio", ratio);
    }
};

/// Point of body j on a curve of body i: one of the three components in the frame of i.
///
///   Φ = e_iᵀ d - c(θ),   e the component's axis, d from the origin of the curve   (1 equation, m)
///
/// θ, the parameter of the curve, is an artificial coordinate.
/// @source slide 11: a coordinate that comes with the joint
struct OnCurve {
    static constexpr int kEquations = 1;
    Vec3 e_i_local;  ///< unit
    Vec3 P_i_local;  ///< origin of the curve [m]
    Vec3 P_j_local;  ///< [m]
    CurveComponent c;

    double unit(double length) const { return length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("e_i_local", e_i_local);
        f("P_i_local", P_i_local);
        f("P_j_local", P_j_local);
        f("constant", c.constant);
        f("linear", c.linear);
        f("harmonics", c.harmonics);
    }
};

template <Content K, class C>
Jet<C, K, 1, kBodyI | kBodyJ | kTheta> equations(
    const OnCurve& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& theta) {
    const auto u = artificial<C, K>(theta);
    auto phi = dot(arm<K, kBodyI>(i, c.e_i_local), vector_between<K>(i, c.P_i_local, j, c.P_j_local)) -
               scaled(c.c.linear, u);
    double k = 0.0;
    for (const auto& [of_cosine, of_sine] : c.c.harmonics) {
        k += 1.0;
        const auto angle = scaled(k, u);
        phi = phi - scaled(of_cosine, cos(angle)) - scaled(of_sine, sin(angle));
    }
    phi.value(0) -= c.c.constant;
    return phi;
}

/// Calls f(sine, cosine) with |e| times sine and cosine of the angle from the line of a wheel to its u.
template <Content K, class C, class F>
auto visit_wheel(const Wheel& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, F&& f) {
    const auto of_line = [&](const auto& s, const auto& u) {
        const auto both = [&](const auto& e) { return f(dot(cross(e, u), s), dot(e, u)); };
        if (c.line == WheelLine::centres) { return both(vector_between<K>(i, c.P_i_local, j, c.P_j_local)); }
        return both(cross(arm<K, kBodyI>(i, c.s_i_local), arm<K, kBodyJ>(j, c.s_j_local)));
    };
    if (!c.of_j) { return of_line(arm<K, kBodyI>(i, c.s_i_local), arm<K, kBodyI>(i, c.u_local)); }
    const auto s = arm<K, kBodyJ>(j, c.s_j_local);
    const auto u = arm<K, kBodyJ>(j, c.u_local);
    if (c.line != WheelLine::rack) { return of_line(s, u); }
    const auto e = arm<K, kBodyI>(i, c.s_i_local);
    return f(dot(cross(e, u), s), dot(e, u));
}

template <Content K, class C>
Jet<C, K, 1, kBodyI | kBodyJ | kTheta> equations(
    const Wheel& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& theta) {
    const auto t = scaled(c.ratio, artificial<C, K>(theta));
    const auto row = [&](const auto& sine, const auto& cosine) {
        return dot(sine, cos(t)) - dot(cosine, sin(t));
    };
    return visit_wheel<K>(c, i, j, row);
}

/// Angle from the line of a wheel to its u in (-π, π] [rad].
template <Content K, class C>
Jet<C, K, 1, kBodyI | kBodyJ> measured(
    const Wheel& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    const auto angle = [](const auto& sine, const auto& cosine) { return atan2(sine, cosine); };
    return visit_wheel<K>(c, i, j, angle);
}

}  // namespace jw
