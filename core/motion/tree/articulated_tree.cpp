#include "core/motion/tree/articulated_tree.hpp"

#include <iterator>

#include "core/motion/tree/tree_passes.hpp"

namespace jw {

ArticulatedTree::ArticulatedTree(const Centroidal& scene, const State& start, Registers registers)
    : registers_(registers),
      joints_(scene, start),
      nodes_(joints_.nodes().size() + 1),
      e_(at(joints_.velocities()), 0.0),
      u_dot_(e_.size(), 0.0) {
    nodes_[0].A = Mat3::Identity();
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        node.parent = joint.parent + 1;
        node.body = joint.body;
        node.hanging = joint.hanging;
        node.turns = joint.turns;
        node.shifts = joint.shifts;
        node.q = joint.position;
        node.q_dot = joint.velocity;
        node.u = joint.velocity - joints_.positions();
        if (node.body >= 0) {
            const MassProperties& own = *scene.loads.masses[at(node.body)];
            node.mass = own.mass;
            node.J_local = own.J_local;
            node.is_principal = own.J_local.isDiagonal(0.0);
        }
        node.own_arm_local = -joint.point_local;
        const Vec3 root_of_parent =
            joint.parent < 0 ? Vec3(Vec3::Zero()) : joints_.nodes()[at(joint.parent)].point_local;
        node.step = joint.point_parent - root_of_parent;
        const Mat3 A = homogeneous_rotation_matrix(joint.p_parent);
        node.still = A;
        if (joint.turns) {
            const Vec3& turn = joint.turn_local;
            const Mat3 along = turn * turn.transpose();
            node.still = A * along;
            node.across = A - A * along;
            node.quarter = A * tilde(turn);
            turning_.push_back(static_cast<int>(n));
        }
        if (node.hanging == Hanging::ball || node.hanging == Hanging::free) {
            with_p_.push_back(static_cast<int>(n));
        }
        node.turn_in_parent = A * joint.turn_local;
        node.shift_in_parent = A * joint.shift_local;
    }
    turns_.resize((turning_.size() + 4) / 4);  // one more may be read than there are angles
    half_turns_.resize(turns_.size());
}

void ArticulatedTree::turn(double share, const double* y, std::vector<FourTurns>& turns) const {
    for (std::size_t k = 0; k < turning_.size(); ++k) {
        turns[k / 4].angle[k % 4] = share * y[nodes_[at(turning_[k])].q];
    }
    find_sines_and_cosines(turns, registers_);
}

void ArticulatedTree::place(const double* y) {
    turn(1.0, y, turns_);
    for (const int n : with_p_) {
        Node& node = nodes_[at(n)];
        const double* position = y + node.q;
        const double* p = node.hanging == Hanging::free ? position + 3 : position;
        node.A = homogeneous_rotation_matrix(vec4(p).normalized());
    }
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        std::size_t k = 0;
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            Node& node = nodes_[n];
            const FourTurns& four = turns_[k / 4];
            tree_passes::place<V>(node, nodes_[at(node.parent)], y, four.cosine[k % 4], four.sine[k % 4]);
            if (node.turns) { ++k; }
        }
    });
}

void ArticulatedTree::find_p(const double* y) {
    turn(0.5, y, half_turns_);
    std::size_t k = 0;
    for (std::size_t n = 1; n < nodes_.size(); ++n) {
        const TreeNode& joint = joints_.nodes()[n - 1];
        Node& node = nodes_[n];
        const Vec4& of_parent = nodes_[at(node.parent)].p;
        const double* position = y + node.q;
        switch (node.hanging) {
            case Hanging::free: node.p = vec4(position + 3).normalized(); break;
            case Hanging::ball: node.p = vec4(position).normalized(); break;
            case Hanging::axis:
                if (joint.turns) {
                    const FourTurns& four = half_turns_[k / 4];
                    node.p = product(
                        of_parent, four.cosine[k % 4] * joint.p_parent + four.sine[k % 4] * joint.p_turned);
                    ++k;
                    break;
                }
                [[fallthrough]];
            case Hanging::welded: node.p = product(of_parent, joint.p_parent); break;
        }
    }
}

void ArticulatedTree::move(const double* y) {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            tree_passes::move<V>(nodes_[n], nodes_[at(nodes_[n].parent)], y);
        }
    });
}

void ArticulatedTree::set_inertias(Metric metric, double length) {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (Node& node : nodes_) {
            node.wrench = Six{};
            const bool by_mass = metric == Metric::mass || node.body < 0;
            const Columns<V> J = by_mass ? tree_passes::J_of<V>(node) : diagonal<V>(length * length);
            node.inertia = inertia_at_root<V>(by_mass ? node.mass : 1.0, J, node.own_arm);
        }
    });
}

void ArticulatedTree::set_inertias_and_wrenches(std::span<const BodyForce> forces) {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            const BodyForce* force = nodes_[n].body < 0 ? nullptr : &forces[at(nodes_[n].body)];
            tree_passes::set_inertia_and_wrench<V>(nodes_[n], force);
        }
    });
}

Six ArticulatedTree::at_root(int n, const Vec3& force, const Vec3& torque) const {
    Six wrench;
    wrench.linear = force;
    wrench.angular = torque + vec3(node(n).own_arm).cross(force);
    return wrench;
}

double ArticulatedTree::drift_along(int n, const Six& on) const {
    return vec3(on.linear).dot(vec3(node(n).bias.linear) + vec3(node(n).inwards)) +
           vec3(on.angular).dot(vec3(node(n).bias.angular));
}

void ArticulatedTree::fold() {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (std::size_t n = nodes_.size(); n-- > 1;) {
            Node& node = nodes_[n];
            tree_passes::fold<V>(node, nodes_[at(node.parent)], std::next(e_.data(), node.u));
        }
    });
}

void ArticulatedTree::set_forces(std::span<const double> drawn, double length) {
    const auto set = [&](int u, double size) {
        for (int k = 0; k < 3; ++k) { e_[at(u + k)] = size * drawn[at(u + k)]; }
    };
    const auto trace = [](const Triples& m) { return m.x.number[0] + m.y.number[1] + m.z.number[2]; };
    for (const Node& node : std::span(nodes_).subspan(1)) {
        switch (node.hanging) {
            case Hanging::welded: break;
            case Hanging::axis:
                e_[at(node.u)] = drawn[at(node.u)] * (node.turns ? 1.0 : length) / node.inverse_D;
                break;
            case Hanging::free:
                set(node.u, 3.0 * length / trace(node.inverse_M));
                set(node.u + 3, 3.0 / trace(node.inverse_J));
                break;
            case Hanging::ball: set(node.u, 3.0 / trace(node.inverse_J)); break;
        }
    }
}

void ArticulatedTree::unfold() {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            Node& node = nodes_[n];
            tree_passes::unfold<V>(
                node, nodes_[at(node.parent)], std::next(e_.data(), node.u),
                std::next(u_dot_.data(), node.u));
        }
    });
}

void ArticulatedTree::accelerate(const double* u_dot) {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            Node& node = nodes_[n];
            tree_passes::accelerate<V>(node, nodes_[at(node.parent)], std::next(u_dot, node.u));
        }
    });
}

std::vector<int> ArticulatedTree::path(int i, int j) const {
    std::vector<int> path;
    for_each_on_way(i, j, [&](int n, Way) {
        for (int k = 0; k < joint_of(n).velocities(); ++k) { path.push_back(node(n).u + k); }
    });
    return path;
}

void ArticulatedTree::respond(
    int i, int j, const Six& on_i, const Six& on_j, double* e, double* e_by_D) const {
    in_registers(registers_, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        SixOf<V> wrench_i = on_i;
        SixOf<V> wrench_j = on_j;
        for_each_on_way(i, j, [&](int n, Way way) JW_PASS {
            const Node& here = nodes_[at(n)];
            SixOf<V>& wrench = way == Way::from_j ? wrench_j : wrench_i;
            // joints transmit the two wrenches in different shares: where the paths meet, their remainders
            // are no longer opposite, and act on all joints down to the ground
            if (way == Way::first_of_both) { wrench = wrench + wrench_j; }
            wrench = tree_passes::respond(here, wrench, e, e_by_D);
            const int numbers = here.hanging == Hanging::axis ? 1 : joint_of(n).velocities();
            e += numbers;
            e_by_D += numbers;
        });
    });
}

}  // namespace jw
