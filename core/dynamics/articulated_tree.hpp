#pragma once

#include <array>
#include <vector>

#include "core/dynamics/joint_tree.hpp"
#include "core/dynamics/loads.hpp"
#include "core/dynamics/spatial_vectors.hpp"

/// Bᵀ M B u̇ = Bᵀ (wrenches) for a tree of bodies, without ever forming B or Bᵀ M B.
///
/// From the tips to the ground every node takes up the inertia of what hangs on it, reduced by what the joint
/// of that lets go (its articulated inertia); from the ground to the tips the answers follow. Cost linear in
/// the bodies. The way down is a factorisation Bᵀ M B = F D Fᵀ with D block diagonal, one block per joint: it
/// leaves e = F⁻¹ Bᵀ (wrenches), the way up finds u̇ = F⁻ᵀ D⁻¹ e.
/// @source Featherstone, Rigid Body Dynamics Algorithms, ch. 7; here along the global axes at the centres of
/// mass
namespace jw {

class ArticulatedTree {
public:
    /// A node as it lies and moves, and what the passes leave at it. Vectors are global.
    struct Node {
        int parent = 0;
        Mat3 A = Mat3::Identity();
        Vec3 r = Vec3::Zero();
        Vec4 p = Vec4::Unit(0);
        Vec3 arm = Vec3::Zero();      ///< from the parent's centre to its own; ball: to where it hangs
        Vec3 own_arm = Vec3::Zero();  ///< ball: from where it hangs to its own centre
        Six axis;                     ///< velocity of its centre, and ω, per q̇
        Six velocity;
        Six bias;          ///< acceleration that the velocities alone cause, Ḃ u
        Inertia6 inertia;  ///< its own and of all that hangs on it
        Six wrench;        ///< on it and on all that hangs on it
        Six acceleration;  ///< B u̇
        Six column_by_D;   ///< axis: inertia times axis, by D = axisᵀ inertia axis
        double inverse_D = 0.0;
        Mat3 inverse_J = Mat3::Zero();    ///< ball, free: where it hangs
        Mat3 inverse_M = Mat3::Zero();    ///< free: of what turning has left of M
        Mat3 H_inverse_J = Mat3::Zero();  ///< ball, free
    };
    /// Of which inertias: those of the masses, or 1 and length² for every body, which know no masses.
    enum class Metric { mass, geometry };

    /// @param scene must outlive this
    /// @param start poses of the bodies; the joints hold there
    ArticulatedTree(const Centroidal& scene, const State& start);

    const JointTree& joints() const { return joints_; }
    /// Node of a body; 0 is what does not move.
    int node_of(int body) const { return joints_.node_of(body) + 1; }
    Node& node(int n) { return nodes_[static_cast<std::size_t>(n)]; }
    const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
    const TreeNode& joint_of(int n) const { return joints_.nodes()[static_cast<std::size_t>(n - 1)]; }
    /// Where the numbers of a node's joint begin in u.
    int first_u(int n) const { return joint_of(n).velocity - joints_.positions(); }

    /// Poses and arms. @param y of JointTree
    void place(const double* y);
    /// Velocities, and what they alone do to accelerations.
    void move(const double* y);
    /// Every node's own, and no wrenches. @param length of a body in the metric of geometry [m]
    void set_inertias(Metric metric, double length = 1.0);
    /// Down: e from the wrenches of the nodes.
    void fold();
    /// Up: u̇ from e.
    void unfold();
    std::vector<double>& e() { return e_; }
    const std::vector<double>& u_dot() const { return u_dot_; }

    /// Where in u a pair of opposite wrenches on nodes i and j is felt: from both down to where their ways to
    /// the ground meet.
    std::vector<int> path(int i, int j) const;
    /// e of such a pair and D⁻¹ e, in the order of the path. The last inertias must have been folded.
    void respond(int i, int j, Six on_i, Six on_j, double* e, double* e_by_D) const;

private:
    void reduce(const TreeNode& joint, Node& node) const;
    /// What the joint gives way to goes to `e`; @return the part that it holds, at the parent's centre
    Six pass_on(const TreeNode& joint, const Node& node, const Six& wrench, double* e) const;

    const Centroidal* scene_;
    JointTree joints_;
    std::vector<Node> nodes_;
    std::vector<std::array<double, 2>> half_turns_;  ///< cos q/2, sin q/2 of the joints that turn
    std::vector<double> e_;
    std::vector<double> u_dot_;
};

}  // namespace jw
