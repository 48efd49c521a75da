#include <algorithm>

#include "core/dynamics/tree_equations.hpp"

/// What the numbers of joint coordinates are: their sizes, the bodies that follow from them, and what lies
/// between steps.
namespace jw {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

/// A turn counts as the way of the farthest point that it moves.
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
    tree_.place(y);
    tree_.move(y);
    for (const int body : moving_) {
        const Node& node = tree_.node(tree_.node_of(body));
        vec3(flat) = node.r;
        vec4(flat + 3) = node.p;
        vec3(flat + 7) = node.velocity.linear;
        vec3(flat + 10) = node.A.transpose() * node.velocity.angular;
        flat += kNumbersPerBody;
    }
}

void TreeEquations::from_flat(const double* flat, double* y) const {
    std::fill_n(y, size(), 0.0);
    const auto numbers_of = [&](int body) {
        const auto m = std::ranges::find(moving_, body) - moving_.begin();
        return body_numbers(flat, static_cast<std::size_t>(m));
    };
    for (const TreeNode& joint : joints().nodes()) {
        if (joint.hanging == Hanging::free) { std::copy_n(numbers_of(joint.body), 7, y + joint.position); }
        if (joint.hanging == Hanging::ball) {
            std::copy_n(numbers_of(joint.body) + 3, 4, y + joint.position);
        }
    }
    // u = (Bᵀ M B)⁻¹ Bᵀ (momenta)
    tree_.place(y);
    tree_.set_inertias(Metric::mass);
    for (const int body : moving_) {
        Node& node = tree_.node(tree_.node_of(body));
        const double* numbers = numbers_of(body);
        node.wrench = times(node.inertia, {vec3(numbers + 7), node.A * vec3(numbers + 10)});
    }
    tree_.fold();
    tree_.unfold();
    add_velocities(y);
}

/// y with the last u̇ added to its velocities.
void TreeEquations::add_velocities(double* y) const {
    double* u = y + joints().positions();
    for (const double change : tree_.u_dot()) { *u++ += change; }
}

/// y moved by the last u̇.
void TreeEquations::displace(double* y) const {
    for (const TreeNode& joint : joints().nodes()) {
        double* position = y + joint.position;
        const double* way = &tree_.u_dot()[at(joint.velocity - joints().positions())];
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis: *position += *way; break;
            case Hanging::free:
                vec3(position) += vec3(way);
                position += 3;
                way += 3;
                [[fallthrough]];
            case Hanging::ball: vec4(position) = turned_local(vec4(position), vec3(way)); break;
        }
    }
}

void TreeEquations::derivatives(const double* y, const double* y_dot, double* out) const {
    const int n = joints().positions();
    std::copy_n(y, n, out);
    std::copy_n(y_dot, n, out + n);
    double* half = out + 2 * n;
    for (const TreeNode& joint : joints().nodes()) {
        const double* position = y + joint.position;
        const double* velocity = y + joint.velocity;
        const double* velocity_dot = y_dot + joint.velocity;
        double* to = half + joint.position;
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis: *to = *velocity_dot; break;
            case Hanging::free:
                vec3(to) = vec3(velocity_dot);
                position += 3;
                velocity += 3;
                velocity_dot += 3;
                to += 3;
                [[fallthrough]];
            case Hanging::ball:
                vec4(to) = p_ddot_of_omega_local(vec4(position), vec3(velocity), vec3(velocity_dot));
                break;
        }
    }
    for (int k = 0; k < n; ++k) { half[k] *= 0.5; }
}

void TreeEquations::flat_of(const double* value, const double* rate, double* flat) const {
    std::copy_n(value, joints().positions(), y_.begin());
    for (const TreeNode& joint : joints().nodes()) {
        double* position = &y_[at(joint.position)];
        double* velocity = y_.data() + joint.velocity;
        const double* position_dot = rate + joint.position;
        switch (joint.hanging) {
            case Hanging::welded: break;
            case Hanging::axis: *velocity = *position_dot; break;
            case Hanging::free:
                vec3(velocity) = vec3(position_dot);
                position += 3;
                velocity += 3;
                position_dot += 3;
                [[fallthrough]];
            case Hanging::ball:
                vec4(position).normalize();
                vec3(velocity) = omega_local_of(vec4(position), vec4(position_dot));
                break;
        }
    }
    to_flat(y_.data(), flat);
}

}  // namespace jw
