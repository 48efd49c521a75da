#pragma once

#include <span>
#include <vector>

#include "core/dynamics/forces.hpp"
#include "core/dynamics/joint_tree.hpp"
#include "core/dynamics/sine_cosine.hpp"
#include "core/dynamics/spatial_vectors.hpp"

/// Bᵀ M B u̇ = Bᵀ (wrenches) for a tree of bodies, without ever forming B or Bᵀ M B.
///
/// From the tips to the ground every node takes up the inertia of what hangs on it, reduced by what the joint
/// of that lets go (its articulated inertia); from the ground to the tips the answers follow. Cost linear in
/// the bodies. The way down is a factorisation Bᵀ M B = F D Fᵀ with D block diagonal, one block per joint: it
/// leaves e = F⁻¹ Bᵀ (wrenches), the way up finds u̇ = F⁻ᵀ D⁻¹ e.
/// @source Featherstone, Rigid Body Dynamics Algorithms, ch. 7; here along the global axes
namespace jw {

class ArticulatedTree {
public:
    /// A node as it lies and moves, and what the passes leave at it. Vectors are global. Velocities, wrenches
    /// and inertias are those at its root: where it hangs, or its own centre of mass if it is free.
    struct Node {
        // what stays
        int parent = 0;
        int body = -1;
        Hanging hanging = Hanging::free;
        bool turns = false;
        bool shifts = false;
        int q = 0;                  ///< where its numbers begin in y
        int q_dot = 0;              ///< and their rates
        int u = 0;                  ///< and these in u
        bool is_principal = false;  ///< J' has nothing beside its diagonal
        double mass = 0.0;
        Triples J_local;
        Triple own_arm_local;
        Triple step;             ///< from the parent's root to its own at q = 0, in the parent's frame
        Triple turn_in_parent;   ///< axis: what a unit q̇ does, in the parent's frame
        Triple shift_in_parent;  ///< the same
        Triples still;  ///< axis, welded: its A in the parent's frame is still + cos q across + sin q quarter
        Triples across;
        Triples quarter;

        // where it is
        Triples A;
        Triple r;        ///< of its root
        Triple arm;      ///< from the parent's root to its own
        Triple own_arm;  ///< from its root to its centre of mass

        // how it moves
        Six axis;  ///< velocity per q̇
        Six velocity;
        Six bias;        ///< acceleration that the velocities alone cause, Ḃ u
        Triple inwards;  ///< of that what turning alone adds on the way to its centre of mass

        // what the passes leave
        Inertia6 inertia;  ///< its own and of all that hangs on it
        Six wrench;        ///< on it and on all that hangs on it
        Six acceleration;  ///< B u̇
        Six column_by_D;   ///< axis: inertia times axis, by D = axisᵀ inertia axis, at the parent's root
        double inverse_D = 0.0;
        Triples inverse_J;       ///< ball, free
        Triples H_inverse_J;     ///< ball, free
        Triples inverse_M;       ///< free: of what turning has left of M
        Vec4 p = Vec4::Unit(0);  ///< after find_p only

        Vec3 centre() const { return vec3(r) + vec3(own_arm); }
        Vec3 velocity_of_centre() const {
            return vec3(velocity.linear) + vec3(velocity.angular).cross(vec3(own_arm));
        }
        Vec3 omega_local() const { return mat3(A).transpose() * vec3(velocity.angular); }
    };
    /// Of which inertias: those of the masses, or 1 and length² for every body, which know no masses.
    enum class Metric { mass, geometry };

    /// @param scene must outlive this
    /// @param start poses of the bodies; the joints hold there
    ArticulatedTree(const Centroidal& scene, const State& start);

    const JointTree& joints() const { return joints_; }
    /// Node of a body; 0 is what does not move.
    int node_of(int body) const { return joints_.node_of(body) + 1; }
    const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
    const TreeNode& joint_of(int n) const { return joints_.nodes()[static_cast<std::size_t>(n - 1)]; }

    /// Poses and arms, without p. @param y of JointTree
    void place(const double* y);
    /// p of all nodes, which have been placed.
    void find_p(const double* y);
    /// Velocities, and what they alone do to accelerations.
    void move(const double* y);
    /// Every node's own, and no wrenches. @param length of a body in the metric of geometry [m]
    void set_inertias(Metric metric, double length = 1.0);
    /// Every node's own, of the masses, and as wrenches Q - M Ḃ u.
    /// @param forces Q, one per body of the mechanism
    void set_inertias_and_wrenches(std::span<const BodyForce> forces);
    /// A wrench at the centre of mass as one at the root.
    Six at_root(int n, const Vec3& force, const Vec3& torque) const;
    /// Acceleration of node n that the velocities alone cause, along such a wrench.
    double drift_along(int n, const Six& on) const;
    /// Down: e from the wrenches of the nodes.
    void fold();
    /// Up: u̇ from e.
    void unfold();
    std::vector<double>& e() { return e_; }
    const std::vector<double>& e() const { return e_; }
    /// e in which every joint, by itself, is moved as `drawn` says: turned by so many rad, shifted by so many
    /// `length`. The last inertias must have been folded. @param drawn one number per velocity
    void set_forces(std::span<const double> drawn, double length);
    const std::vector<double>& u_dot() const { return u_dot_; }

    /// Accelerations B u̇ of the nodes, of any u̇.
    void accelerate(const double* u_dot);

    /// Columns of E = Φq B F⁻ᵀ in which a row between nodes i and j has entries: the joints of both ways to
    /// the ground, the common part of them once. (Φq B alone ends where the two ways meet; F⁻ᵀ does not.)
    std::vector<int> path(int i, int j) const;
    /// e of a pair of opposite wrenches on nodes i and j, and D⁻¹ e, in the order of the path. The last
    /// inertias must have been folded.
    /// @param on_i at the root of node i; on_j likewise
    void respond(int i, int j, const Six& on_i, const Six& on_j, double* e, double* e_by_D) const;

private:
    /// Part of the way from two nodes to the ground.
    enum class Way { from_i, from_j, first_of_both, both };
    /// Calls `f(n, way)` for every node n on the ways from nodes i and j to the ground, tips first.
    template <class F>
    JW_INLINE void for_each_on_way(int i, int j, F&& f) const {
        while (i != j) {
            int& n = i > j ? i : j;
            f(n, i > j ? Way::from_i : Way::from_j);
            n = node(n).parent;
        }
        for (Way way = Way::first_of_both; i != 0; i = node(i).parent) {
            f(i, way);
            way = Way::both;
        }
    }
    /// Sines and cosines of a share of what every joint has turned.
    void turn(double share, const double* y, std::vector<FourTurns>& turns) const;

    JointTree joints_;
    std::vector<Node> nodes_;
    std::vector<int> turning_;      ///< nodes whose joints turn
    std::vector<FourTurns> turns_;  ///< of them, four by four
    std::vector<FourTurns> half_turns_;
    std::vector<int> with_p_;  ///< nodes with p of their own
    std::vector<double> e_;
    std::vector<double> u_dot_;
};

}  // namespace jw
