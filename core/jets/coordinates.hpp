#pragma once

#include <utility>

#include "core/jets/euler_parameters.hpp"

/// The four coordinate choices of slides 13-22. A choice supplies the matrix A, the derivative of an
/// arm A s' and the columns of p; nothing else in the program knows which choice is in use.
///
/// | choice                    | columns   | A    | d(A s')               | d²(A s'), quadratic part   |
/// | true Euler parameters     | r, p (7)  | A_N  | 2 (G bar(s') + s' pᵀ) | 2 Ġ L̇ᵀ s' + 2 (ṗ·ṗ) s'     |
/// | modified Euler parameters | r, p (7)  | G Lᵀ | 2 G bar(s')           | 2 Ġ L̇ᵀ s'                  |
/// | omega local               | r, ω' (6) | G Lᵀ | -A s̃'                 | ω x (ω x A s')             |
/// | omega global              | r, ω (6)  | G Lᵀ | -(A s')~              | ω x (ω x A s')             |
///
/// The functions of the choices are templates, so code that only names a choice does not compile them.
///
/// @source tables of pp. 201, 203 and 299 (slides 20-22), corrected as in docs/notation.md
namespace jw {

enum class CoordinateChoice { true_euler_parameters, modified_euler_parameters, omega_local, omega_global };

/// Kinematics of one body as the equations need it, computed once per body and state.
template <class C>
struct BodyKinematics {
    Vec3 r = Vec3::Zero();
    Vec4 p = Vec4::Unit(0);
    Mat3 A = Mat3::Identity();
    Mat34 G = Mat34::Zero();
    Vec3 r_dot = Vec3::Zero();
    Vec4 p_dot = Vec4::Zero();
    Mat3 A_dot = Mat3::Zero();   ///< d(A)/dt
    Mat3 A_bias = Mat3::Zero();  ///< d²(A)/dt² with zero accelerations of the choice
    Vec4 p_bias = Vec4::Zero();  ///< p̈ with zero accelerations of the choice
};

/// Artificial coordinate θ and its rate; primitives without an artificial coordinate ignore them.
struct Theta {
    double value = 0.0;
    double rate = 0.0;
};

/// θ in the form that the equations of a choice need.
template <class C>
struct ThetaOfChoice {
    using Type = Theta;
};
template <class C>
using ThetaOf = typename ThetaOfChoice<C>::Type;

/// Base of the two (r, p) choices: seven columns and a row pᵀp = 1 for every moving body.
struct EulerParameterColumns {
    static constexpr int kAngular = 4;
    static constexpr bool kNormalised = true;

    /// Row of the derivatives of e_k by the angular coordinates of one body.
    static Eigen::Matrix<double, 1, 4> parameter_block(const auto& /*p*/, int k) {
        return Eigen::Matrix<double, 1, 4>::Unit(k);
    }
    /// 2 Ġ L̇ᵀ
    static Mat3 two_G_dot_L_dot(const auto& p_dot) { return 2.0 * G_of(p_dot) * L_of(p_dot).transpose(); }
};

struct TrueEulerParameters : EulerParameterColumns {
    static constexpr CoordinateChoice kChoice = CoordinateChoice::true_euler_parameters;

    static Mat3 rotation(const Vec4& p) { return rotation_matrix(p); }
    static Mat34 arm_block(const auto& b, const Vec3& s_local, const Vec3& /*s*/) {
        return 2.0 * (b.G * bar(s_local) + s_local * b.p.transpose());
    }
    static void set_motion(auto& b, const Vec3& omega_local) {
        b.p_dot = p_dot_of_omega_local(b.p, omega_local);
        b.A_dot = 2.0 * (b.G * L_of(b.p_dot).transpose() + b.p.dot(b.p_dot) * Mat3::Identity());
        b.A_bias = two_G_dot_L_dot(b.p_dot) + 2.0 * b.p_dot.squaredNorm() * Mat3::Identity();
    }
};

struct ModifiedEulerParameters : EulerParameterColumns {
    static constexpr CoordinateChoice kChoice = CoordinateChoice::modified_euler_parameters;

    static Mat3 rotation(const Vec4& p) { return homogeneous_rotation_matrix(p); }
    static Mat34 arm_block(const auto& b, const Vec3& s_local, const Vec3& /*s*/) {
        return 2.0 * b.G * bar(s_local);
    }
    static void set_motion(auto& b, const Vec3& omega_local) {
        b.p_dot = p_dot_of_omega_local(b.p, omega_local);
        b.A_dot = 2.0 * b.G * L_of(b.p_dot).transpose();
        b.A_bias = two_G_dot_L_dot(b.p_dot);
    }
};

/// Base of the two ω choices: six columns, no normalisation row.
struct OmegaColumns {
    static constexpr int kAngular = 3;
    static constexpr bool kNormalised = false;

    static Mat3 rotation(const Vec4& p) { return homogeneous_rotation_matrix(p); }

    static void set_motion(auto& b, const Vec3& omega_local) {
        const Mat3 omega_local_tilde = tilde(omega_local);
        b.p_dot = p_dot_of_omega_local(b.p, omega_local);
        b.A_dot = b.A * omega_local_tilde;
        b.A_bias = b.A_dot * omega_local_tilde;
        b.p_bias = -0.25 * omega_local.squaredNorm() * b.p;
    }
};

struct OmegaLocal : OmegaColumns {
    static constexpr CoordinateChoice kChoice = CoordinateChoice::omega_local;

    static Mat3 arm_block(const auto& b, const Vec3& s_local, const Vec3& /*s*/) {
        return -b.A * tilde(s_local);
    }
    static Eigen::Matrix<double, 1, 3> parameter_block(const auto& p, int k) {
        return 0.5 * L_of(p).transpose().row(k);
    }
};

struct OmegaGlobal : OmegaColumns {
    static constexpr CoordinateChoice kChoice = CoordinateChoice::omega_global;

    static Mat3 arm_block(const auto& /*b*/, const Vec3& /*s_local*/, const Vec3& s) { return -tilde(s); }
    static Eigen::Matrix<double, 1, 3> parameter_block(const auto& p, int k) {
        return 0.5 * G_of(p).transpose().row(k);
    }
};

/// Columns of one moving body: r and the angular coordinates.
template <class C>
inline constexpr int kColumnsPerBody = 3 + C::kAngular;

/// Calls `f` with an object of the choice's type: the only place where a value at run time becomes a type.
template <class F>
decltype(auto) with_choice(CoordinateChoice choice, F&& f) {
    switch (choice) {
        case CoordinateChoice::true_euler_parameters: return std::forward<F>(f)(TrueEulerParameters{});
        case CoordinateChoice::modified_euler_parameters:
            return std::forward<F>(f)(ModifiedEulerParameters{});
        case CoordinateChoice::omega_global: return std::forward<F>(f)(OmegaGlobal{});
        case CoordinateChoice::omega_local: break;
    }
    return std::forward<F>(f)(OmegaLocal{});
}

}  // namespace jw
