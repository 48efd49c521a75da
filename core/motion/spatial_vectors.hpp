#pragma once

#include "core/numerics/triples.hpp"

/// Spatial vectors and inertias: wrenches, velocities with ω, and the inertias that relate them, at a point,
/// along the global axes.
namespace jw {

/// Spatial vector in registers V: force and torque, or the linear and the angular part of a motion; at a
/// point, global axes.
template <Lanes V>
struct SixOf {
    V linear;
    V angular;
};

/// Spatial inertia in registers V: [f; n] = [M H; Hᵀ J] [v̇; ω̇], at a point, global axes.
template <Lanes V>
struct InertiaOf {
    Columns<V> M;
    Columns<V> H;
    Columns<V> J;
};

/// Spatial vector in memory.
struct Six {
    Triple linear;
    Triple angular;

    template <Lanes V>
    JW_INLINE Six& operator=(const SixOf<V>& six) {
        linear = six.linear;
        angular = six.angular;
        return *this;
    }
    template <Lanes V>
    JW_INLINE operator SixOf<V>() const {
        return {V(linear), V(angular)};
    }
};

/// Inertia of a body or of a branch of the tree, in memory.
struct Inertia6 {
    Triples M;
    Triples H;
    Triples J;

    template <Lanes V>
    JW_INLINE Inertia6& operator=(const InertiaOf<V>& inertia) {
        M = inertia.M;
        H = inertia.H;
        J = inertia.J;
        return *this;
    }
    template <Lanes V>
    JW_INLINE operator InertiaOf<V>() const {
        return {M, H, J};
    }
};

template <Lanes V>
JW_INLINE SixOf<V> operator+(const SixOf<V>& a, const SixOf<V>& b) {
    return {a.linear + b.linear, a.angular + b.angular};
}
template <Lanes V>
JW_INLINE SixOf<V> operator-(const SixOf<V>& a, const SixOf<V>& b) {
    return {a.linear - b.linear, a.angular - b.angular};
}
template <Lanes V>
JW_INLINE SixOf<V> operator*(double factor, const SixOf<V>& a) {
    return {factor * a.linear, factor * a.angular};
}
template <Lanes V>
JW_INLINE double dot(const SixOf<V>& a, const SixOf<V>& b) {
    return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}
template <Lanes V>
JW_INLINE InertiaOf<V> operator+(const InertiaOf<V>& a, const InertiaOf<V>& b) {
    return {a.M + b.M, a.H + b.H, a.J + b.J};
}

/// Inertia of a body, J about its centre of mass, at the point from which `arm` leads to the centre of mass.
template <Lanes V>
JW_INLINE InertiaOf<V> inertia_at_root(double mass, const Columns<V>& J, const V& arm) {
    const V moment = -mass * arm;
    return {diagonal<V>(mass), tilde(moment), J - diagonal<V>(dot(arm, moment)) + dyad(arm, moment)};
}

/// Transfers an inertia to the point from which `arm` leads to its own: Xᵀ I X, with X the transfer of
/// accelerations from that point to its own. J + ã H + (ã H)ᵀ - ã M ã is computed as J + ã K + (ã K)ᵀ with K
/// the mean of the two H.
template <Lanes V>
JW_INLINE InertiaOf<V> at_root_of(const InertiaOf<V>& inertia, const V& arm) {
    const Columns<V> H = inertia.H - times_tilde(inertia.M, arm);
    const Columns<V> turned = tilde_times(arm, 0.5 * (inertia.H + H));
    return {inertia.M, H, inertia.J + turned + transposed(turned)};
}

/// Transfers a wrench in the same way.
template <Lanes V>
JW_INLINE SixOf<V> at_root_of(const SixOf<V>& wrench, const V& arm) {
    return {wrench.linear, wrench.angular + cross(arm, wrench.linear)};
}

/// Velocity or acceleration at the end of an arm, without the centripetal acceleration.
template <Lanes V>
JW_INLINE SixOf<V> at_end_of(const SixOf<V>& motion, const V& arm) {
    return {motion.linear + cross(motion.angular, arm), motion.angular};
}

/// I - c cᵀ / d
template <Lanes V>
JW_INLINE InertiaOf<V> without_square(
    const InertiaOf<V>& inertia, const SixOf<V>& c, const SixOf<V>& c_by_d) {
    return {
        inertia.M - dyad(c_by_d.linear, c.linear), inertia.H - dyad(c_by_d.linear, c.angular),
        inertia.J - dyad(c_by_d.angular, c.angular)};
}

}  // namespace jw
