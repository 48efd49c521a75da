#pragma once

#include "core/jets/coordinates.hpp"

/// Kinematics of a body in the form that the equations need, from its pose and its motion.
namespace jw {

/// Kinematics of a body at a pose; its motion is not set.
template <class C>
BodyKinematics<C> kinematics_at(const Vec3& r, const Vec4& p) {
    BodyKinematics<C> body;
    body.r = r;
    body.p = p;
    body.A = C::rotation(p);
    body.G = G_of(p);
    return body;
}

template <class C>
BodyKinematics<C> kinematics_at(const Vec3& r, const Vec4& p, const Vec3& r_dot, const Vec3& omega_local) {
    BodyKinematics<C> body = kinematics_at<C>(r, p);
    body.r_dot = r_dot;
    C::set_motion(body, omega_local);
    return body;
}

/// Angular velocity in the coordinates of a choice: ω', ω or ṗ.
template <class C>
using Angular = Eigen::Matrix<double, C::kAngular, 1>;

/// Converts ω' to the coordinates of the choice. p need not be a unit quaternion: at stages of an integrator
/// it is not. ω̇' is converted to ω̇ or p̈ (without its part along p) in the same way (slide 13).
template <class C>
Angular<C> angular_of(const Vec4& p, const Vec3& omega_local) {
    if constexpr (C::kNormalised) {
        return p_dot_of_omega_local(p, omega_local);
    } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
        return homogeneous_rotation_matrix(p) * omega_local;
    } else {
        return omega_local;
    }
}

template <class C>
Vec3 omega_local_of_angular(const Vec4& p, const Angular<C>& angular) {
    if constexpr (C::kNormalised) {
        return omega_local_of(p, angular);
    } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
        return homogeneous_rotation_matrix(p).transpose() * angular;
    } else {
        return angular;
    }
}

}  // namespace jw
