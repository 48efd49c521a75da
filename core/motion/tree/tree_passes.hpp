#pragma once

#include "core/motion/tree/articulated_tree.hpp"

/// Passes of ArticulatedTree at one node, in registers V.
namespace jw::tree_passes {

using Node = ArticulatedTree::Node;

template <Lanes V>
JW_INLINE void store(const V& v, double* numbers) {
    for (int k = 0; k < 3; ++k) { numbers[k] = v[k]; }
}

/// Computes pose and arms of a node.
/// @param cosine, sine of the node's angle, if it turns
template <Lanes V>
JW_INLINE void place(Node& node, const Node& parent, const double* y, double cosine, double sine) {
    const Columns<V> A_parent = parent.A;
    V arm = A_parent * V(node.step);
    if (node.hanging == Hanging::free) {
        arm = V::of_three(y + node.q);
    } else if (node.hanging != Hanging::ball) {
        Columns<V> A = node.still;
        if (node.turns) {
            A = A + cosine * Columns<V>(node.across) + sine * Columns<V>(node.quarter);
            node.axis.angular = A_parent * V(node.turn_in_parent);
        }
        node.A = A_parent * A;
        if (node.shifts) {
            const V shift = A_parent * V(node.shift_in_parent);
            node.axis.linear = shift;
            arm = arm + y[node.q] * shift;
        }
    }
    node.arm = arm;
    node.r = V(parent.r) + arm;
    node.own_arm = Columns<V>(node.A) * V(node.own_arm_local);
}

template <Lanes V>
JW_INLINE void move(Node& node, const Node& parent, const double* y) {
    const V arm = node.arm;
    const V omega_parent = parent.velocity.angular;
    const V alpha_parent = parent.bias.angular;
    const double* rates = y + node.q_dot;
    V way = cross(omega_parent, arm);
    V bias = V(parent.bias.linear) + cross(alpha_parent, arm) + cross(omega_parent, way);
    switch (node.hanging) {
        case Hanging::axis: {
            const V turn = rates[0] * V(node.axis.angular);
            node.velocity.angular = omega_parent + turn;
            node.bias.angular = alpha_parent + cross(omega_parent, turn);
            if (node.shifts) {
                const V shift = rates[0] * V(node.axis.linear);
                way = way + shift;
                bias = bias + 2.0 * cross(omega_parent, shift);
            }
            break;
        }
        case Hanging::ball: node.velocity.angular = Columns<V>(node.A) * V::of_three(rates); break;
        case Hanging::free:
            way = V::of_three(rates);
            node.velocity.angular = Columns<V>(node.A) * V::of_three(rates + 3);
            break;
        case Hanging::welded:
            node.velocity.angular = omega_parent;
            node.bias.angular = alpha_parent;
            break;
    }
    node.velocity.linear = V(parent.velocity.linear) + way;
    node.bias.linear = bias;
    const V omega = node.velocity.angular;
    node.inwards = cross(omega, cross(omega, V(node.own_arm)));
}

/// J along the global axes, A J' Aᵀ.
template <Lanes V>
JW_INLINE Columns<V> J_of(const Node& node) {
    const Columns<V> A = node.A;
    if (!node.is_principal) { return (A * Columns<V>(node.J_local)) * transposed(A); }
    const Triples& J = node.J_local;
    return dyad(A.x, J.x.number[0] * A.x) + dyad(A.y, J.y.number[1] * A.y) + dyad(A.z, J.z.number[2] * A.z);
}

/// Sets the node's own inertia and the wrench Q - M Ḃ u.
/// @param Q nullptr if the node is massless
template <Lanes V>
JW_INLINE void set_inertia_and_wrench(Node& node, const BodyForce* Q) {
    if (Q == nullptr) {
        node.inertia = Inertia6{};
        node.wrench = Six{};
        return;
    }
    const V arm = node.own_arm;
    const V omega = node.velocity.angular;
    const V alpha = node.bias.angular;
    const Columns<V> A = node.A;
    const Columns<V> J = J_of<V>(node);
    const V of_centre = V(node.bias.linear) + cross(alpha, arm) + V(node.inwards);
    const V force = V::of_three(Q->f.data()) - node.mass * of_centre;
    const V torque = A * V::of_three(Q->n_local.data()) - cross(omega, J * omega) - J * alpha;
    node.inertia = inertia_at_root(node.mass, J, arm);
    node.wrench = SixOf<V>{force, torque + cross(arm, force)};
}

/// Pass down over a joint with one coordinate.
/// @param e the node's numbers
template <Lanes V>
JW_INLINE void fold_axis(Node& node, Node& parent, double* e) {
    const InertiaOf<V> inertia = node.inertia;
    const SixOf<V> wrench = node.wrench;
    const SixOf<V> axis = node.axis;
    // for rotation only; translation adds terms
    SixOf<V> column{inertia.H * axis.angular, inertia.J * axis.angular};
    double D = dot(axis.angular, column.angular);
    *e = dot(axis.angular, wrench.angular);
    if (node.shifts) {
        column = column + SixOf<V>{inertia.M * axis.linear, transposed_times(inertia.H, axis.linear)};
        D = dot(axis, column);
        *e = dot(axis, wrench);
    }
    const V arm = node.arm;
    column = at_root_of(column, arm);
    node.inverse_D = 1.0 / D;
    const SixOf<V> column_by_D = node.inverse_D * column;
    node.column_by_D = column_by_D;
    if (node.parent == 0) { return; }
    // transfer first, then reduce, because only the reduction depends on D
    const InertiaOf<V> all = InertiaOf<V>(parent.inertia) + at_root_of(inertia, arm);
    const SixOf<V> all_wrench = SixOf<V>(parent.wrench) + at_root_of(wrench, arm);
    parent.inertia = without_square(all, column, column_by_D);
    parent.wrench = all_wrench - *e * column_by_D;
}

/// Reduces the inertia by three rotations, which transmit no torque. @return the remaining M
template <Lanes V>
JW_INLINE Columns<V> let_go_of_turning(Node& node) {
    const InertiaOf<V> inertia = node.inertia;
    const Columns<V> inverse_J = inverse_of_symmetric(inertia.J);
    const Columns<V> H_inverse_J = inertia.H * inverse_J;
    node.inverse_J = inverse_J;
    node.H_inverse_J = H_inverse_J;
    return inertia.M - H_inverse_J * transposed(inertia.H);
}

/// Force that remains of a wrench when the joint transmits no torque.
template <Lanes V>
JW_INLINE V force_without_torque(const Node& node, const SixOf<V>& wrench) {
    return wrench.linear - Columns<V>(node.H_inverse_J) * wrench.angular;
}

template <Lanes V>
JW_INLINE void fold_ball(Node& node, Node& parent, double* e) {
    const SixOf<V> wrench = node.wrench;
    const V arm = node.arm;
    const Columns<V> M = let_go_of_turning<V>(node);
    const Columns<V> H = diagonal<V>(0.0) - times_tilde(M, arm);
    store(wrench.angular, e);
    if (node.parent == 0) { return; }
    const V force = force_without_torque(node, wrench);
    parent.inertia = InertiaOf<V>(parent.inertia) + InertiaOf<V>{M, H, tilde_times(arm, H)};
    parent.wrench = SixOf<V>(parent.wrench) + SixOf<V>{force, cross(arm, force)};
}

template <Lanes V>
JW_INLINE void fold(Node& node, Node& parent, double* e) {
    switch (node.hanging) {
        case Hanging::axis: fold_axis<V>(node, parent, e); break;
        case Hanging::ball: fold_ball<V>(node, parent, e); break;
        case Hanging::free:
            node.inverse_M = inverse_of_symmetric(let_go_of_turning<V>(node));
            store(force_without_torque<V>(node, node.wrench), e);
            store(V(node.wrench.angular), e + 3);
            break;
        case Hanging::welded: {
            if (node.parent == 0) { break; }
            const V arm = node.arm;
            parent.inertia = InertiaOf<V>(parent.inertia) + at_root_of(InertiaOf<V>(node.inertia), arm);
            parent.wrench = SixOf<V>(parent.wrench) + at_root_of(SixOf<V>(node.wrench), arm);
            break;
        }
    }
}

/// Pass up.
/// @param e, u_dot the node's numbers
template <Lanes V>
JW_INLINE void unfold(Node& node, const Node& parent, const double* e, double* u_dot) {
    const SixOf<V> of_parent = parent.acceleration;
    SixOf<V> acceleration = at_end_of(of_parent, V(node.arm));
    if (node.hanging == Hanging::axis) {
        *u_dot = node.inverse_D * *e - dot(SixOf<V>(node.column_by_D), of_parent);
        acceleration.angular = acceleration.angular + *u_dot * V(node.axis.angular);
        if (node.shifts) { acceleration.linear = acceleration.linear + *u_dot * V(node.axis.linear); }
    } else if (node.hanging != Hanging::welded) {
        if (node.hanging == Hanging::free) {
            acceleration.linear = Columns<V>(node.inverse_M) * V::of_three(e);
            store(acceleration.linear, u_dot);
            e += 3;
            u_dot += 3;
        }
        acceleration.angular = Columns<V>(node.inverse_J) * V::of_three(e) -
                               transposed_times(Columns<V>(node.H_inverse_J), acceleration.linear);
        store(transposed_times(Columns<V>(node.A), acceleration.angular), u_dot);
    }
    node.acceleration = acceleration;
}

/// Acceleration B u̇ of the node.
/// @param u_dot the node's numbers
template <Lanes V>
JW_INLINE void accelerate(Node& node, const Node& parent, const double* u_dot) {
    SixOf<V> acceleration = at_end_of(SixOf<V>(parent.acceleration), V(node.arm));
    switch (node.hanging) {
        case Hanging::welded: break;
        case Hanging::axis:
            acceleration.angular = acceleration.angular + *u_dot * V(node.axis.angular);
            if (node.shifts) { acceleration.linear = acceleration.linear + *u_dot * V(node.axis.linear); }
            break;
        case Hanging::free:
            acceleration.linear = V::of_three(u_dot);
            acceleration.angular = Columns<V>(node.A) * V::of_three(u_dot + 3);
            break;
        case Hanging::ball: acceleration.angular = Columns<V>(node.A) * V::of_three(u_dot); break;
    }
    node.acceleration = acceleration;
}

/// Writes the components of a wrench along the joint's freedoms to e, and D⁻¹ e. @return the transmitted
/// wrench, at the parent's root
template <Lanes V>
JW_INLINE SixOf<V> respond(const Node& node, const SixOf<V>& wrench, double* e, double* e_by_D) {
    const V arm = node.arm;
    switch (node.hanging) {
        case Hanging::axis:
            *e = dot(V(node.axis.angular), wrench.angular);
            if (node.shifts) { *e += dot(V(node.axis.linear), wrench.linear); }
            *e_by_D = node.inverse_D * *e;
            return at_root_of(wrench, arm) - *e * SixOf<V>(node.column_by_D);
        case Hanging::ball:
            store(wrench.angular, e);
            store(Columns<V>(node.inverse_J) * wrench.angular, e_by_D);
            break;
        case Hanging::free: {
            const V force = force_without_torque(node, wrench);
            store(force, e);
            store(wrench.angular, e + 3);
            store(Columns<V>(node.inverse_M) * force, e_by_D);
            store(Columns<V>(node.inverse_J) * wrench.angular, e_by_D + 3);
            break;
        }
        case Hanging::welded: return at_root_of(wrench, arm);
    }
    const V force = force_without_torque(node, wrench);
    return {force, cross(arm, force)};
}

}  // namespace jw::tree_passes
