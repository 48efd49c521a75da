#pragma once

#include "core/linear.hpp"

/// Forces with torques, velocities with ω, and inertias that join them: six numbers at a point, along the
/// global axes.
namespace jw {

/// [f; n] = [M H; Hᵀ J] [v̇; ω̇], at a point, global axes.
struct Inertia6 {
    Mat3 M = Mat3::Zero();
    Mat3 H = Mat3::Zero();
    Mat3 J = Mat3::Zero();
};

/// Force and torque, or (of motions) the linear and the angular part; at a point, global axes. Each begins
/// where a pair of numbers does: pairs that are read otherwise than they were written are waited for.
struct Six {
    EIGEN_ALIGN16 Vec3 linear = Vec3::Zero();
    EIGEN_ALIGN16 Vec3 angular = Vec3::Zero();
};

/// The same inertia at a point that lies `arm` before this one: Xᵀ I X with X the accelerations here by those
/// there. H - M ã and J + ã (H - M ã) + (ã H)ᵀ, where rows of M times ã are vectors' products: vᵀ ã = (v x
/// a)ᵀ.
inline Inertia6 at_root_of(const Inertia6& inertia, const Vec3& arm) {
    Inertia6 out;
    out.M = inertia.M;
    for (int k = 0; k < 3; ++k) { out.H.row(k) = inertia.H.row(k) - inertia.M.col(k).cross(arm).transpose(); }
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        const int last = (i + 2) % 3;
        for (int j = i; j < 3; ++j) {
            const int next_j = (j + 1) % 3;
            const int last_j = (j + 2) % 3;
            // of a x the column j of the new H, and of a x the column i of the old one
            const double turned = arm(next) * out.H(last, j) - arm(last) * out.H(next, j);
            const double back = arm(next_j) * inertia.H(last_j, i) - arm(last_j) * inertia.H(next_j, i);
            out.J(i, j) = out.J(j, i) = inertia.J(i, j) + turned + back;
        }
    }
    return out;
}

/// The same for a wrench.
inline Six at_root_of(const Six& wrench, const Vec3& arm) {
    return {wrench.linear, wrench.angular + arm.cross(wrench.linear)};
}

/// Velocity or acceleration at the end of an arm; what turning adds to accelerations is not in it.
inline Six at_end_of(const Six& motion, const Vec3& arm) {
    return {motion.linear + motion.angular.cross(arm), motion.angular};
}

inline double dot(const Six& a, const Six& b) { return a.linear.dot(b.linear) + a.angular.dot(b.angular); }

inline Six operator*(double factor, const Six& a) { return {factor * a.linear, factor * a.angular}; }

inline void add_scaled(Six& a, double factor, const Six& b) {
    a.linear += factor * b.linear;
    a.angular += factor * b.angular;
}

/// [M H; Hᵀ J] x
inline Six times(const Inertia6& inertia, const Six& x) {
    return {
        inertia.M * x.linear + inertia.H * x.angular,
        inertia.H.transpose() * x.linear + inertia.J * x.angular};
}

/// I - c cᵀ / d
inline void subtract_square(Inertia6& inertia, const Six& c, const Six& c_by_d) {
    inertia.M.noalias() -= c.linear * c_by_d.linear.transpose();
    inertia.H.noalias() -= c.linear * c_by_d.angular.transpose();
    inertia.J.noalias() -= c.angular * c_by_d.angular.transpose();
}

inline void add(Inertia6& a, const Inertia6& b) {
    a.M += b.M;
    a.H += b.H;
    a.J += b.J;
}

}  // namespace jw
