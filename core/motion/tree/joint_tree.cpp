#include "core/motion/tree/joint_tree.hpp"

#include <algorithm>

namespace jw {

namespace {

bool can_hang(const Joint& joint) {
    const bool by_hand = joint.parallel_form == ParallelForm::drop_x ||
                         joint.parallel_form == ParallelForm::drop_y ||
                         joint.parallel_form == ParallelForm::drop_z || !joint.without.empty();
    return !by_hand && joint.type->can_carry();
}

/// Motion along one coordinate, in the frame that the child has at the start.
struct Axis {
    Vec3 turn = Vec3::Zero();
    Vec3 shift = Vec3::Zero();
};

/// Places where a body may hang on another: anywhere if the joint does not turn it, on its axis of rotation,
/// or at the one point that all its turns leave in place.
enum class Support { anywhere, axis, point };

Support support_of(std::span<const Freedom> motion) {
    Support support = Support::anywhere;
    for (const Freedom freedom : motion) {
        switch (freedom) {
            case Freedom::slide:
            case Freedom::slide_across:
            case Freedom::slide_upright: break;
            case Freedom::turn:
            case Freedom::screw: support = std::max(support, Support::axis); break;
            case Freedom::turn_of_carrier:
            case Freedom::ball: support = Support::point; break;
        }
    }
    return support;
}

/// The place nearest to the centre of mass: there the inertia keeps the most digits.
Vec3 nearest_to_centre(std::span<const Freedom> motion, const Vec3& point, const Vec3& s) {
    switch (support_of(motion)) {
        case Support::anywhere: return Vec3::Zero();
        case Support::axis: return point - s.dot(point) * s;
        case Support::point: break;
    }
    return point;
}

constexpr int kNotYet = -1;

/// Heaviest body that has no depth yet, the first of equal ones; -1 if all have. The inertia of a light body
/// would be lost in that of the bodies that it carries.
int heaviest_left(const Loads& loads, const std::vector<int>& depth) {
    int heaviest = -1;
    for (std::size_t b = 0; b < depth.size(); ++b) {
        if (depth[b] != kNotYet) { continue; }
        if (heaviest < 0 || loads.masses[b]->mass > loads.masses[at(heaviest)]->mass) {
            heaviest = static_cast<int>(b);
        }
    }
    return heaviest;
}

/// The axes of a joint, from the parent on; empty for a ball and a weld.
/// @param s_parent the parent's axis in the child's frame
std::vector<Axis> axes_of(const Joint& joint, const Vec3& s_parent, const Vec3& s) {
    const Vec3 none = Vec3::Zero();
    const Vec3 across = perpendicular_to(s);
    std::vector<Axis> axes;
    for (const Freedom freedom : joint.type->motion) {
        switch (freedom) {
            case Freedom::turn: axes.push_back({s, none}); break;
            case Freedom::turn_of_carrier: axes.push_back({s_parent, none}); break;
            case Freedom::slide: axes.push_back({none, s}); break;
            case Freedom::slide_across: axes.push_back({none, across}); break;
            case Freedom::slide_upright: axes.push_back({none, s.cross(across)}); break;
            case Freedom::screw: axes.push_back({s, joint.geometry.alpha * s}); break;
            case Freedom::ball: break;
        }
    }
    return axes;
}

}  // namespace

int TreeNode::positions() const {
    switch (hanging) {
        case Hanging::welded: return 0;
        case Hanging::axis: return 1;
        case Hanging::ball: return 4;
        case Hanging::free: break;
    }
    return 7;
}

int TreeNode::velocities() const {
    switch (hanging) {
        case Hanging::welded: return 0;
        case Hanging::axis: return 1;
        case Hanging::ball: return 3;
        case Hanging::free: break;
    }
    return 6;
}

JointTree::JointTree(const Centroidal& scene, const State& start)
    : in_tree_(scene.mechanism.joints.size(), false), node_of_body_(scene.mechanism.bodies.size(), -1) {
    const Mechanism& mechanism = scene.mechanism;
    std::vector<int> depth(mechanism.bodies.size(), kNotYet);
    for (std::size_t b = 0; b < depth.size(); ++b) {
        if (mechanism.bodies[b].fixed) { depth[b] = 0; }
    }
    for (;;) {
        const Edge edge = next_edge(mechanism, depth);
        if (edge.joint >= 0) {
            hang(mechanism, start, edge);
            in_tree_[at(edge.joint)] = true;
            depth[at(edge.child_body)] = depth[at(edge.parent_body)] + 1;
            continue;
        }
        const int heaviest = heaviest_left(scene.loads, depth);
        if (heaviest < 0) { break; }
        TreeNode node;
        node.body = heaviest;
        add(node);
        depth[at(heaviest)] = 0;
    }
    for (TreeNode& node : nodes_) { node.velocity += positions_; }
    find_reaches();
}

JointTree::Edge JointTree::next_edge(const Mechanism& mechanism, const std::vector<int>& depth) const {
    Edge best;
    const auto is_better = [&](int dof, int from) {
        if (best.joint < 0) { return true; }
        const int least = mechanism.joints[at(best.joint)].type->dof;
        return dof < least || (dof == least && depth[at(from)] < depth[at(best.parent_body)]);
    };
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const Joint& joint = mechanism.joints[k];
        const bool hangs_i = depth[at(joint.body_i)] >= 0;
        const bool hangs_j = depth[at(joint.body_j)] >= 0;
        if (hangs_i == hangs_j || !can_hang(joint)) { continue; }
        const int parent = hangs_i ? joint.body_i : joint.body_j;
        const int child = hangs_i ? joint.body_j : joint.body_i;
        if (is_better(joint.type->dof, parent)) { best = {static_cast<int>(k), parent, child}; }
    }
    return best;
}

void JointTree::hang(const Mechanism& mechanism, const State& start, const Edge& edge) {
    const Joint& joint = mechanism.joints[at(edge.joint)];
    const JointGeometry& g = joint.geometry;
    const bool child_is_j = edge.child_body == joint.body_j;
    const Vec3 s = (child_is_j ? g.s_j_local : g.s_i_local).normalized();
    const Vec3 point = nearest_to_centre(joint.type->motion, child_is_j ? g.P_j_local : g.P_i_local, s);
    const Vec3 s_other = (child_is_j ? g.s_i_local : g.s_j_local).normalized();

    const Vec3& r = start.r[at(edge.child_body)];
    const Vec4& p = start.p[at(edge.child_body)];
    const Mat3 A = rotation_matrix(p);
    const Mat3 A_parent = rotation_matrix(start.p[at(edge.parent_body)]);
    const auto conjugate = [](const Vec4& q) { return Vec4(q(0), -q(1), -q(2), -q(3)); };

    TreeNode node;
    node.parent = node_of_body_[at(edge.parent_body)];
    node.point_parent = r + A * point;
    node.p_parent = p;
    if (node.parent >= 0) {
        const Vec4& p_of_parent = start.p[at(edge.parent_body)];
        node.point_parent = A_parent.transpose() * (node.point_parent - start.r[at(edge.parent_body)]);
        node.p_parent = product(conjugate(p_of_parent), p);
    }
    const std::vector<Axis> axes = axes_of(joint, A.transpose() * (A_parent * s_other), s);
    // massless nodes have the child's orientation and lie where it hangs
    for (std::size_t k = 0; k + 1 < axes.size(); ++k) {
        node.hanging = Hanging::axis;
        node.turn_local = axes[k].turn;
        node.shift_local = axes[k].shift;
        add(node);
        node = {};
        node.parent = static_cast<int>(nodes_.size()) - 1;
    }
    node.body = edge.child_body;
    node.point_local = point;
    if (axes.empty()) {
        node.hanging = joint.type->dof == 0 ? Hanging::welded : Hanging::ball;
    } else {
        node.hanging = Hanging::axis;
        node.turn_local = axes.back().turn;
        node.shift_local = axes.back().shift;
    }
    add(node);
}

void JointTree::add(TreeNode node) {
    node.turns = node.turn_local != Vec3::Zero();
    node.shifts = node.shift_local != Vec3::Zero();
    Vec4 half_turn;
    half_turn << 0.0, node.turn_local;
    node.p_turned = product(node.p_parent, half_turn);
    node.position = positions_;
    node.velocity = velocities_;
    positions_ += node.positions();
    velocities_ += node.velocities();
    if (node.body >= 0) { node_of_body_[at(node.body)] = static_cast<int>(nodes_.size()); }
    nodes_.push_back(node);
}

void JointTree::find_reaches() {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        TreeNode& node = nodes_[n];
        node.reach = std::max(node.reach, node.point_local.norm());
        if (node.parent < 0) { continue; }
        TreeNode& parent = nodes_[at(node.parent)];
        parent.reach = std::max(parent.reach, (node.point_parent - parent.point_local).norm() + node.reach);
    }
}

}  // namespace jw
