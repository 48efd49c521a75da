#pragma once

#include <span>
#include <vector>

#include "core/motion/flat_state.hpp"
#include "core/motion/loads.hpp"

/// A mechanism as a tree of bodies that hang from each other, with its loops cut: the basis of joint
/// coordinates.
namespace jw {

/// Connection of a node of the tree to its parent.
enum class Hanging {
    welded,
    axis,  ///< one coordinate q: a turn about an axis, a displacement along it, or (screw) both
    ball,  ///< its own p and ω', one point constrained
    free   ///< its own r, p, ṙ, ω', not constrained
};

/// Node of the tree: a body, or a massless one between two axes of the same joint (cylindrical, universal,
/// planar). At q = 0 it lies relative to its parent as at the start. turn' and shift' are the effect of a
/// unit q̇: the node's ω and its velocity at the point where it hangs; both are fixed in the node, and have
/// the same components in its parent.
struct TreeNode {
    int body = -1;    ///< in the mechanism; -1: massless
    int parent = -1;  ///< an earlier node; -1: the fixed bodies, with the global frame
    Hanging hanging = Hanging::free;
    Vec3 point_parent = Vec3::Zero();  ///< point where it hangs at q = 0, in the parent's frame [m]
    Vec3 point_local = Vec3::Zero();   ///< the same point of the node, in its own frame [m]
    Vec4 p_parent = Vec4::Unit(0);     ///< axis, welded: its orientation at q = 0, in the parent's frame
    Vec3 turn_local = Vec3::Zero();    ///< axis: [rad] per q
    Vec3 shift_local = Vec3::Zero();   ///< axis: [m] per q
    // derived from these
    bool turns = false;
    bool shifts = false;
    Vec4 p_turned = Vec4::Zero();  ///< p_parent times (0, turn'): p is cos(q/2) p_parent + sin(q/2) p_turned
    int position = 0;              ///< index in y where its q, its p, or its r and p begin
    int velocity = 0;              ///< index in y where its q̇, its ω', or its ṙ and ω' begin
    /// Largest distance that the bodies hanging on this node can reach from its point [m].
    double reach = 0.0;

    int positions() const;
    int velocities() const;
};

/// Tree of joints. y = all positions, then all velocities, node by node.
class JointTree {
public:
    /// Chooses the joints of the tree: those with the fewest freedoms, then those nearest to the ground;
    /// a joint with equations chosen or taken out by hand stays an equation. If no such joint connects some
    /// bodies to the tree, the heaviest of them moves freely and carries the others.
    /// @param start poses of all bodies, which satisfy the joints
    JointTree(const Centroidal& scene, const State& start);

    std::span<const TreeNode> nodes() const { return nodes_; }
    int positions() const { return positions_; }
    int velocities() const { return velocities_; }
    /// True if a joint of the mechanism is part of the tree; all others, and the drivers, are left as
    /// equations.
    bool has_joint(int joint) const { return in_tree_[static_cast<std::size_t>(joint)]; }
    /// Visits the parts of y with the places where they and their rates begin: `number(position, velocity)`
    /// for every q, `way(...)` for every r, `turn(...)` for every p and its ω'.
    template <class Number, class Way, class Turn>
    void for_each_part(Number&& number, Way&& way, Turn&& turn) const {
        for (const TreeNode& node : nodes_) {
            switch (node.hanging) {
                case Hanging::welded: break;
                case Hanging::axis: number(node.position, node.velocity); break;
                case Hanging::ball: turn(node.position, node.velocity); break;
                case Hanging::free:
                    way(node.position, node.velocity);
                    turn(node.position + 3, node.velocity + 3);
                    break;
            }
        }
    }
    /// Node of a body, -1 for one that does not move.
    int node_of(int body) const { return node_of_body_[static_cast<std::size_t>(body)]; }

private:
    struct Edge {
        int joint = -1;
        int parent_body = -1;
        int child_body = -1;
    };
    Edge next_edge(const Mechanism& mechanism, const std::vector<int>& depth) const;
    void hang(const Mechanism& mechanism, const State& start, const Edge& edge);
    void add(TreeNode node);
    void find_reaches();

    std::vector<TreeNode> nodes_;
    std::vector<bool> in_tree_;
    std::vector<int> node_of_body_;
    int positions_ = 0;
    int velocities_ = 0;
};

}  // namespace jw
