#include <algorithm>

#include "core/motion/tree/tree_equations.hpp"

/// Joint coordinates: their scales, conversion to and from poses, and the numbers that are interpolated.
namespace jw {

/// Weights a rotation by the displacement of the farthest point that it moves.
std::vector<NumberScale> TreeEquations::scales() const {
    using Kind = NumberScale::Kind;
    std::vector<NumberScale> out(at(size()));
    for (const TreeNode& joint : joints().nodes()) {
        const double far = std::max(1.0, joint.reach / extent_);
        const auto set = [&](int first, int count, Kind kind, double weight) {
            for (int k = 0; k < count; ++k) { out[at(first + k)] = {kind, weight}; }
        };
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis:
                set(joint.position, 1, joint.turns ? Kind::turn : Kind::way, joint.turns ? far : 1.0);
                set(joint.velocity, 1, joint.turns ? Kind::omega : Kind::velocity, joint.turns ? far : 1.0);
                break;
            case Hanging::ball:
                set(joint.position, 4, Kind::turn, far);
                set(joint.velocity, 3, Kind::omega, far);
                break;
            case Hanging::free:
                set(joint.position, 3, Kind::way, 1.0);
                set(joint.position + 3, 4, Kind::turn, far);
                set(joint.velocity, 3, Kind::velocity, 1.0);
                set(joint.velocity + 3, 3, Kind::omega, far);
                break;
        }
    }
    return out;
}

void TreeEquations::to_flat(const double* y, double* flat) const {
    place(y);
    tree_.find_p(y);
    for (const int body : moving_) {
        const Node& node = tree_.node(tree_.node_of(body));
        vec3(flat) = node.centre();
        vec4(flat + 3) = node.p;
        vec3(flat + 7) = node.velocity_of_centre();
        vec3(flat + 10) = node.omega_local();
        flat += kNumbersPerBody;
    }
}

void TreeEquations::from_flat(const double* flat, double* y) const {
    std::fill_n(y, size(), 0.0);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const TreeNode& joint = tree_.joint_of(tree_.node_of(moving_[m]));
        const double* numbers = body_numbers(flat, m);
        if (joint.hanging == Hanging::free) { std::copy_n(numbers, 7, y + joint.position); }
        if (joint.hanging == Hanging::ball) { std::copy_n(numbers + 3, 4, y + joint.position); }
    }
    // u = (Bᵀ M B)⁻¹ Bᵀ (momenta): the momenta are applied as forces to a tree at rest
    std::vector<BodyForce> momenta(bodies_.size());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const MassProperties& own = *scene_->loads.masses[at(moving_[m])];
        const double* velocity = body_numbers(flat, m) + 7;
        momenta[at(moving_[m])] = {own.mass * vec3(velocity), own.J_local * vec3(velocity + 3)};
    }
    place(y);
    tree_.set_inertias_and_wrenches(momenta);
    tree_.fold();
    tree_.unfold();
    add_velocities(y);
}

/// Adds the last u̇ to the velocities of y.
void TreeEquations::add_velocities(double* y) const {
    double* u = y + joints().positions();
    for (const double change : tree_.u_dot()) { *u++ += change; }
}

/// Moves the positions of y by the last u̇.
void TreeEquations::displace(double* y) const {
    const auto way = [&](int velocity) { return &tree_.u_dot()[at(velocity - joints().positions())]; };
    joints().for_each_part(
        [&](int q, int q_dot) { y[q] += *way(q_dot); },
        [&](int r, int r_dot) { vec3(y + r) += vec3(way(r_dot)); },
        [&](int p, int omega) { vec4(y + p) = turned_local(vec4(y + p), vec3(way(omega))); });
}

void TreeEquations::derivatives(const double* y, const double* y_dot, double* out) const {
    const int n = joints().positions();
    std::copy_n(y, n, out);
    std::copy_n(y_dot, n, out + n);
    double* half = out + 2 * n;
    joints().for_each_part(
        [&](int q, int q_dot) { half[q] = 0.5 * y_dot[q_dot]; },
        [&](int r, int r_dot) { vec3(half + r) = 0.5 * vec3(y_dot + r_dot); },
        [&](int p, int omega) {
            vec4(half + p) = 0.5 * p_ddot_of_omega_local(vec4(y + p), vec3(y + omega), vec3(y_dot + omega));
        });
}

void TreeEquations::state_of(const double* value, const double* rate, double* y) const {
    std::copy_n(value, joints().positions(), y);
    joints().for_each_part(
        [&](int q, int q_dot) { y[q_dot] = rate[q]; },
        [&](int r, int r_dot) { vec3(y + r_dot) = vec3(rate + r); },
        [&](int p, int omega) {
            vec4(y + p).normalize();
            vec3(y + omega) = omega_local_of(vec4(y + p), vec4(rate + p));
        });
}

void TreeEquations::flat_of(const double* value, const double* rate, double* flat) const {
    state_of(value, rate, y_.data());
    to_flat(y_.data(), flat);
}

}  // namespace jw
