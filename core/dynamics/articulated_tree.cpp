#include "core/dynamics/articulated_tree.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/LU>

namespace jw {

ArticulatedTree::ArticulatedTree(const Centroidal& scene, const State& start)
    : scene_(&scene),
      joints_(scene.mechanism, start),
      nodes_(joints_.nodes().size() + 1),
      half_turns_(joints_.nodes().size()),
      e_(at(joints_.velocities()), 0.0),
      u_dot_(e_.size(), 0.0) {
    for (std::size_t n = 1; n < nodes_.size(); ++n) { nodes_[n].parent = joints_.nodes()[n - 1].parent + 1; }
}

void ArticulatedTree::place(const double* y) {
    // all of them first: in the chain of nodes each would be waited for
    for (std::size_t n = 0; n < half_turns_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n];
        if (joint.turns) {
            const double half = 0.5 * y[joint.position];
            half_turns_[n] = {std::cos(half), std::sin(half)};
        }
    }
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        const Node& parent = nodes_[at(node.parent)];
        const double* position = y + joint.position;
        if (joint.hanging == Hanging::free) {
            node.r = vec3(position);
            node.p = vec4(position + 3).normalized();
            node.A = homogeneous_rotation_matrix(node.p);
            continue;
        }
        node.arm = parent.A * joint.point_parent;
        if (joint.hanging == Hanging::ball) {
            node.p = vec4(position).normalized();
            node.A = homogeneous_rotation_matrix(node.p);
            node.own_arm = -(node.A * joint.point_local);
            node.r = parent.r + node.arm + node.own_arm;
            continue;
        }
        if (joint.turns) {
            const auto [cosine, sine] = half_turns_[n - 1];
            node.p = product(parent.p, cosine * joint.p_parent + sine * joint.p_turned);
        } else {
            node.p = product(parent.p, joint.p_parent);
        }
        node.A = homogeneous_rotation_matrix(node.p);
        if (joint.hanging == Hanging::axis) {
            node.axis.linear = node.A * joint.way_local;
            node.axis.angular = node.A * joint.turn_local;
        }
        if (joint.shifts) { node.arm += *position * (node.A * joint.shift_local); }
        node.arm -= node.A * joint.point_local;
        node.r = parent.r + node.arm;
    }
}

void ArticulatedTree::move(const double* y) {
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        const Node& parent = nodes_[at(node.parent)];
        const double* velocity = y + joint.velocity;
        const Vec3& omega_parent = parent.velocity.angular;
        switch (joint.hanging) {
            case Hanging::free: node.velocity = {vec3(velocity), node.A * vec3(velocity + 3)}; break;
            case Hanging::ball: {
                const Vec3 omega = node.A * vec3(velocity);
                const Vec3 way = omega_parent.cross(node.arm);
                const Vec3 own_way = omega.cross(node.own_arm);
                node.velocity = {parent.velocity.linear + way + own_way, omega};
                node.bias.linear = parent.bias.linear + parent.bias.angular.cross(node.arm) +
                                   omega_parent.cross(way) + omega.cross(own_way);
                break;
            }
            case Hanging::axis: {
                const Six joint_velocity = *velocity * node.axis;
                const Vec3 way = omega_parent.cross(node.arm) + joint_velocity.linear;
                node.velocity.linear = parent.velocity.linear + way;
                node.velocity.angular = omega_parent + joint_velocity.angular;
                node.bias.linear = parent.bias.linear + parent.bias.angular.cross(node.arm) +
                                   omega_parent.cross(way) +
                                   node.velocity.angular.cross(joint_velocity.linear);
                node.bias.angular = parent.bias.angular + omega_parent.cross(joint_velocity.angular);
                break;
            }
            case Hanging::welded:
                node.velocity = at_end_of(parent.velocity, node.arm);
                node.bias = at_end_of(parent.bias, node.arm);
                node.bias.linear += omega_parent.cross(omega_parent.cross(node.arm));
                break;
        }
    }
}

void ArticulatedTree::set_inertias(Metric metric, double length) {
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        Node& node = nodes_[n];
        const int body = joints_.nodes()[n - 1].body;
        node.inertia.H.setZero();
        node.wrench = {};
        if (body < 0) {
            node.inertia = {};
            continue;
        }
        if (metric == Metric::geometry) {
            node.inertia.M = Mat3::Identity();
            node.inertia.J = length * length * Mat3::Identity();
            continue;
        }
        const MassProperties& own = *scene_->loads.masses[at(body)];
        node.inertia.M = own.mass * Mat3::Identity();
        node.inertia.J.noalias() = (node.A * own.J_local) * node.A.transpose();
    }
}

/// Takes from a node's inertia what its joint lets go.
void ArticulatedTree::reduce(const TreeNode& joint, Node& node) const {
    if (joint.hanging == Hanging::welded) { return; }
    if (joint.hanging == Hanging::axis) {
        const Six column = times(node.inertia, node.axis);
        node.inverse_D = 1.0 / dot(node.axis, column);
        node.column_by_D = node.inverse_D * column;
        subtract_square(node.inertia, column, node.column_by_D);
        return;
    }
    const Inertia6 held = at_root_of(node.inertia, node.own_arm);
    node.inverse_J = held.J.inverse();
    node.H_inverse_J = held.H * node.inverse_J;
    node.inertia = {};
    node.inertia.M = held.M - node.H_inverse_J * held.H.transpose();
    if (joint.hanging == Hanging::free) { node.inverse_M = node.inertia.M.inverse(); }
}

Six ArticulatedTree::pass_on(const TreeNode& joint, const Node& node, const Six& wrench, double* e) const {
    switch (joint.hanging) {
        case Hanging::welded: return at_root_of(wrench, node.arm);
        case Hanging::axis: {
            *e = dot(node.axis, wrench);
            Six held = wrench;
            add_scaled(held, -*e, node.column_by_D);
            return at_root_of(held, node.arm);
        }
        case Hanging::ball: {
            const Vec3 torque = at_root_of(wrench, node.own_arm).angular;
            vec3(e) = torque;
            const Vec3 force = wrench.linear - node.H_inverse_J * torque;
            return {force, node.arm.cross(force)};
        }
        case Hanging::free: break;
    }
    vec3(e) = wrench.linear - node.H_inverse_J * wrench.angular;
    vec3(e + 3) = wrench.angular;
    return {};
}

void ArticulatedTree::fold() {
    for (std::size_t n = nodes_.size(); n-- > 1;) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        reduce(joint, node);
        const Six held =
            pass_on(joint, node, node.wrench, std::next(e_.data(), first_u(static_cast<int>(n))));
        if (node.parent == 0) { continue; }
        Node& parent = nodes_[at(node.parent)];
        add(parent.inertia, at_root_of(node.inertia, node.arm));
        add_scaled(parent.wrench, 1.0, held);
    }
}

void ArticulatedTree::unfold() {
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        // a welded node has none: its place may be the end
        const int u = first_u(static_cast<int>(n));
        const double* e = std::next(e_.data(), u);
        double* u_dot = std::next(u_dot_.data(), u);
        node.acceleration = at_end_of(nodes_[at(node.parent)].acceleration, node.arm);
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis:
                *u_dot = node.inverse_D * *e - dot(node.column_by_D, node.acceleration);
                add_scaled(node.acceleration, *u_dot, node.axis);
                break;
            case Hanging::free:
                node.acceleration.linear = node.inverse_M * vec3(e);
                vec3(u_dot) = node.acceleration.linear;
                e += 3;
                u_dot += 3;
                [[fallthrough]];
            case Hanging::ball:
                node.acceleration.angular =
                    node.inverse_J * vec3(e) - node.H_inverse_J.transpose() * node.acceleration.linear;
                vec3(u_dot) = node.A.transpose() * node.acceleration.angular;
                node.acceleration = at_end_of(node.acceleration, node.own_arm);
                break;
        }
    }
}

std::vector<int> ArticulatedTree::path(int i, int j) const {
    std::vector<int> path;
    while (i != j) {
        int& n = i > j ? i : j;
        for (int k = 0; k < joint_of(n).velocities(); ++k) { path.push_back(first_u(n) + k); }
        n = node(n).parent;
    }
    return path;
}

void ArticulatedTree::respond(int i, int j, Six on_i, Six on_j, double* e, double* e_by_D) const {
    while (i != j) {
        int& n = i > j ? i : j;
        Six& wrench = i > j ? on_i : on_j;
        const TreeNode& joint = joint_of(n);
        const Node& here = node(n);
        wrench = pass_on(joint, here, wrench, e);
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis: *e_by_D = here.inverse_D * *e; break;
            case Hanging::ball: vec3(e_by_D) = here.inverse_J * vec3(e); break;
            case Hanging::free:
                vec3(e_by_D) = here.inverse_M * vec3(e);
                vec3(e_by_D + 3) = here.inverse_J * vec3(e + 3);
                break;
        }
        e += joint.velocities();
        e_by_D += joint.velocities();
        n = here.parent;
    }
}

}  // namespace jw
