#pragma once

#include <numbers>
#include <variant>

#include "core/jets/rare_equations.hpp"

/// The primitive constraints: each is its data and one line. Value, Jacobian in every coordinate choice
/// and γ follow from the line (vector_jet.hpp).
///
/// Throughout: s = A s', d = (r_j + A_j B_j') - (r_i + A_i B_i').
///
/// `unit(length)`: size of Φ's gradient when unknowns are measured in units of `length` [m]; Φ and its rows
/// are divided by it before they are compared. `for_each_field(f)` calls f(name, value) for every field.
namespace jw {

/// n1: two body-fixed vectors stay perpendicular.
///
///   Φ = s_iᵀ s_j                                                               (1 equation)
///
/// Singular when s_i and s_j become parallel: both angular blocks vanish.
/// @source slide 2
struct N1 {
    static constexpr int kEquations = 1;
    Vec3 s_i_local;  ///< in body i; its length scales the equation
    Vec3 s_j_local;  ///< in body j; its length scales the equation

    double unit(double /*length*/) const { return s_i_local.norm() * s_j_local.norm(); }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("s_j_local", s_j_local);
    }
};

/// n2: a body-fixed vector stays perpendicular to the vector between two points.
///
///   Φ = s_iᵀ d                                                                 (1 equation, m)
///
/// Harmless at d = 0: the r columns are -s_iᵀ, s_iᵀ.
/// @source slides 2-3
struct N2 {
    static constexpr int kEquations = 1;
    Vec3 s_i_local;
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]

    double unit(double length) const { return s_i_local.norm() * length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("B_i_local", B_i_local);
        f("B_j_local", B_j_local);
    }
};

/// n2 with the vector fixed in the second body.
///
///   Φ = s_jᵀ d                                                                 (1 equation, m)
///
/// @source slides 2-3, bodies exchanged
struct N2J {
    static constexpr int kEquations = 1;
    Vec3 s_j_local;
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]

    double unit(double length) const { return s_j_local.norm() * length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_j_local", s_j_local);
        f("B_i_local", B_i_local);
        f("B_j_local", B_j_local);
    }
};

/// p1: two body-fixed vectors stay parallel.
///
///   Φ = s̃_i s_j                                           (3 equations, two of them independent)
///
/// Anti-parallel vectors satisfy it too; which two to keep: independent_rows.hpp.
/// @source slides 3-5
struct P1 {
    static constexpr int kEquations = 3;
    Vec3 s_i_local;
    Vec3 s_j_local;

    double unit(double /*length*/) const { return s_i_local.norm() * s_j_local.norm(); }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("s_j_local", s_j_local);
    }
};

/// p2: a body-fixed vector stays parallel to the vector between two points.
///
///   Φ = s̃_i d                                          (3 equations, two of them independent, m)
///
/// Harmless at d = 0 (the point lies on the line).
/// @source slides 3-5
struct P2 {
    static constexpr int kEquations = 3;
    Vec3 s_i_local;
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]

    double unit(double length) const { return s_i_local.norm() * length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("B_i_local", B_i_local);
        f("B_j_local", B_j_local);
    }
};

/// s: two points coincide.
///
///   Φ = r_i + A_i P_i' - A_j P_j' - r_j                                        (3 equations, m)
///
/// @source slide 6
struct S {
    static constexpr int kEquations = 3;
    Vec3 P_i_local;  ///< [m]
    Vec3 P_j_local;  ///< [m]

    double unit(double length) const { return length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("P_i_local", P_i_local);
        f("P_j_local", P_j_local);
    }
};

/// Two points keep their distance: a rod with two spherical ends.
///
///   Φ = dᵀd - L²                                                               (1 equation, m²)
///
/// @source book ch. 7, spherical-spherical joint
struct Distance {
    static constexpr int kEquations = 1;
    Vec3 P_i_local;  ///< [m]
    Vec3 P_j_local;  ///< [m]
    double length;   ///< [m], > 0

    double unit(double of_length) const { return 2.0 * length * of_length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("P_i_local", P_i_local);
        f("P_j_local", P_j_local);
        f("length", length);
    }
};

/// p1 written as two n1: with a, b, s_i orthonormal in body i, a·s_j = b·s_j = 0. Condition 1 for every axis.
struct N1Pair {
    static constexpr int kEquations = 2;
    Vec3 a_i_local;
    Vec3 b_i_local;
    Vec3 s_j_local;

    double unit(double /*length*/) const { return s_j_local.norm(); }
    template <class F>
    void for_each_field(F&& f) const {
        f("a_i_local", a_i_local);
        f("b_i_local", b_i_local);
        f("s_j_local", s_j_local);
    }
};

/// p2 written as two n2: a·d = b·d = 0 [m].
struct N2Pair {
    static constexpr int kEquations = 2;
    Vec3 a_i_local;
    Vec3 b_i_local;
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]

    double unit(double length) const { return length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("a_i_local", a_i_local);
        f("b_i_local", b_i_local);
        f("B_i_local", B_i_local);
        f("B_j_local", B_j_local);
    }
};

/// Screw, advance: the nut moves α for every radian.
///
///   Φ = (d - d0) - α (θ - θ0),   d = s_iᵀ d signed, s_i unit                    (1 equation, m)
///
/// α > 0 is a right-hand thread; θ is an artificial coordinate.
/// @source slide 11
struct ScrewAdvance {
    static constexpr int kEquations = 1;
    Vec3 s_i_local;  ///< unit
    Vec3 B_i_local;  ///< [m]
    Vec3 B_j_local;  ///< [m]
    double alpha;    ///< [m/rad]
    double d_0;      ///< [m]
    double theta_0;  ///< [rad]

    double unit(double length) const { return length; }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("B_i_local", B_i_local);
        f("B_j_local", B_j_local);
        f("alpha", alpha);
        f("d_0", d_0);
        f("theta_0", theta_0);
    }
};

/// Form of the equation that ties θ of a screw to the bodies.
enum class ScrewAngleForm {
    rotation,  ///< (u_i x u_j)·s cosθ - (u_i·u_j) sinθ: sound at every θ, condition 1.44
    cosine,    ///< u_i·u_j - cosθ of slide 11: no derivative at θ = kπ, mirrored branch beyond
    sine,      ///< (u_i x u_j)·s - sinθ: no derivative at θ = π/2 + kπ
};

/// Screw, angle: θ is the right-handed angle from u_i to u_j about s_i.
///
///   Φ as given by ScrewAngleForm                                               (1 equation)
///
/// @source slide 11; docs/notation.md
struct ScrewAngle {
    static constexpr int kEquations = 1;
    Vec3 s_i_local;  ///< unit
    Vec3 u_i_local;  ///< unit, perpendicular to s_i
    Vec3 u_j_local;  ///< unit
    ScrewAngleForm form;

    double unit(double /*length*/) const { return 1.0; }
    template <class F>
    void for_each_field(F&& f) const {
        f("s_i_local", s_i_local);
        f("u_i_local", u_i_local);
        f("u_j_local", u_j_local);
        f("form", form);
    }
};

using Primitive = std::variant<
    N1, N2, N2J, P1, P2, S, Distance, N1Pair, N2Pair, FormulaEquation, ScrewAdvance, ScrewAngle, Wheel,
    OnCurve>;

template <Content K, class C>
auto equations(
    const N1& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return dot(arm<K, kBodyI>(i, c.s_i_local), arm<K, kBodyJ>(j, c.s_j_local));
}

template <Content K, class C>
auto equations(
    const N2& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return dot(arm<K, kBodyI>(i, c.s_i_local), vector_between<K>(i, c.B_i_local, j, c.B_j_local));
}

template <Content K, class C>
auto equations(
    const N2J& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return dot(arm<K, kBodyJ>(j, c.s_j_local), vector_between<K>(i, c.B_i_local, j, c.B_j_local));
}

template <Content K, class C>
auto equations(
    const P1& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return cross(arm<K, kBodyI>(i, c.s_i_local), arm<K, kBodyJ>(j, c.s_j_local));
}

template <Content K, class C>
auto equations(
    const P2& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return cross(arm<K, kBodyI>(i, c.s_i_local), vector_between<K>(i, c.B_i_local, j, c.B_j_local));
}

template <Content K, class C>
auto equations(
    const S& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    return point<K, kBodyI>(i, c.P_i_local) - point<K, kBodyJ>(j, c.P_j_local);
}

template <Content K, class C>
auto squared_distance(
    const BodyKinematics<C>& i, const Vec3& P_i_local, const BodyKinematics<C>& j, const Vec3& P_j_local) {
    const auto d = vector_between<K>(i, P_i_local, j, P_j_local);
    return dot(d, d);
}

template <Content K, class C>
auto equations(
    const Distance& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    auto phi = squared_distance<K>(i, c.P_i_local, j, c.P_j_local);
    phi.value(0) -= c.length * c.length;
    return phi;
}

/// Two scalar jets, one above the other.
template <class C, Content K, unsigned S>
Jet<C, K, 2, S> stacked(const Jet<C, K, 1, S>& top, const Jet<C, K, 1, S>& bottom) {
    Jet<C, K, 2, S> out;
    out.value << top.value, bottom.value;
    if constexpr (K == Content::motion) {
        out.rate << top.rate, bottom.rate;
        out.bias << top.bias, bottom.bias;
    } else {
        if constexpr ((S & kBodyI) != 0) { out.block_i << top.block_i, bottom.block_i; }
        if constexpr ((S & kBodyJ) != 0) { out.block_j << top.block_j, bottom.block_j; }
    }
    return out;
}

template <Content K, class C>
auto equations(
    const N1Pair& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    const auto s_j = arm<K, kBodyJ>(j, c.s_j_local);
    return stacked(dot(arm<K, kBodyI>(i, c.a_i_local), s_j), dot(arm<K, kBodyI>(i, c.b_i_local), s_j));
}

template <Content K, class C>
auto equations(
    const N2Pair& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& /*theta*/) {
    const auto d = vector_between<K>(i, c.B_i_local, j, c.B_j_local);
    return stacked(dot(arm<K, kBodyI>(i, c.a_i_local), d), dot(arm<K, kBodyI>(i, c.b_i_local), d));
}

template <Content K, class C>
auto equations(
    const ScrewAdvance& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& theta) {
    const auto d = dot(arm<K, kBodyI>(i, c.s_i_local), vector_between<K>(i, c.B_i_local, j, c.B_j_local));
    auto phi = d - scaled(c.alpha, artificial<C, K>(theta));
    phi.value(0) -= c.d_0 - c.alpha * c.theta_0;
    return phi;
}

template <Content K, class C>
auto equations(
    const ScrewAngle& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& theta) {
    const auto u_i = arm<K, kBodyI>(i, c.u_i_local);
    const auto u_j = arm<K, kBodyJ>(j, c.u_j_local);
    const auto t = artificial<C, K>(theta);
    const auto cosine = dot(u_i, u_j);
    const auto sine = dot(cross(u_i, u_j), arm<K, kBodyI>(i, c.s_i_local));
    switch (c.form) {
        case ScrewAngleForm::cosine: return cosine - cos(t);
        case ScrewAngleForm::sine: return sine - sin(t);
        case ScrewAngleForm::rotation: break;
    }
    return dot(sine, cos(t)) - dot(cosine, sin(t));
}

}  // namespace jw
