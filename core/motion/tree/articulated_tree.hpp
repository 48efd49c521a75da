#pragma once

#include <span>
#include <vector>

#include "core/motion/forces.hpp"
#include "core/motion/spatial_vectors.hpp"
#include "core/motion/tree/joint_tree.hpp"
#include "core/numerics/sine_cosine.hpp"

/// Solution of Bᵀ M B u̇ = Bᵀ (wrenches) for a tree of bodies, without forming B or Bᵀ M B.
///
/// From the tips to the ground, every node receives the inertia of its children, reduced by the freedoms of
/// their joints (articulated-body inertia); from the ground to the tips, the accelerations follow. The cost
/// is linear in the bodies. The pass down is a factorisation Bᵀ M B = F D Fᵀ with D block diagonal, one block
/// per joint: it computes e = F⁻¹ Bᵀ (wrenches), and the pass up computes u̇ = F⁻ᵀ D⁻¹ e.
/// @source Featherstone, Rigid Body Dynamics Algorithms, ch. 7; here along the global axes
namespace jw {

class ArticulatedTree {
public:
    /// Pose and motion of a node, and the results of the passes. Vectors are global. Velocities, wrenches and
    /// inertias refer to the node's root: the point where it hangs, or its own centre of mass if it is free.
    struct Node {
        // constant
        int parent = 0;
        int body = -1;
        Hanging hanging = Hanging::free;
        bool turns = false;
        bool shifts = false;
        int q = 0;                  ///< index of its positions in y
        int q_dot = 0;              ///< index of its velocities in y
        int u = 0;                  ///< index of its velocities in u
        bool is_principal = false;  ///< whether J' is diagonal
        double mass = 0.0;
        Triples J_local;
        Triple own_arm_local;
        Triple step;             ///< from the parent's root to its own at q = 0, in the parent's frame
        Triple turn_in_parent;   ///< axis: ω of a unit q̇, in the parent's frame
        Triple shift_in_parent;  ///< axis: velocity of a unit q̇, in the parent's frame
        Triples still;  ///< axis, welded: A in the parent's frame is still + cos q across + sin q quarter
        Triples across;
        Triples quarter;

        // pose
        Triples A;
        Triple r;        ///< its root
        Triple arm;      ///< from the parent's root to its own
        Triple own_arm;  ///< from its root to its centre of mass

        // motion
        Six axis;  ///< velocity per q̇
        Six velocity;
        Six bias;        ///< acceleration due to velocities alone, Ḃ u
        Triple inwards;  ///< centripetal acceleration of the centre of mass about the root

        // results of the passes
        Inertia6 inertia;  ///< articulated inertia
        Six wrench;        ///< articulated wrench
        Six acceleration;  ///< B u̇
        Six column_by_D;   ///< axis: inertia axis / D with D = axisᵀ inertia axis, at the parent's root
        double inverse_D = 0.0;
        Triples inverse_J;       ///< ball, free
        Triples H_inverse_J;     ///< ball, free
        Triples inverse_M;       ///< free: inverse of M reduced by the rotations
        Vec4 p = Vec4::Unit(0);  ///< set by find_p only

        Vec3 centre() const { return vec3(r) + vec3(own_arm); }
        Vec3 velocity_of_centre() const {
            return vec3(velocity.linear) + vec3(velocity.angular).cross(vec3(own_arm));
        }
        Vec3 omega_local() const { return mat3(A).transpose() * vec3(velocity.angular); }
    };
    /// Inertias to use: those of the masses, or, independent of masses, 1 and length² for every body.
    enum class Metric { mass, geometry };

    /// @param scene must outlive this
    /// @param start poses of the bodies, which satisfy the joints
    /// @param registers in which the passes compute
    ArticulatedTree(const Centroidal& scene, const State& start, Registers registers);

    const JointTree& joints() const { return joints_; }
    /// Node of a body; 0 is the ground.
    int node_of(int body) const { return joints_.node_of(body) + 1; }
    /// Node n, from 0 (ground) on, and its joint, from 1 on.
    const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
    const TreeNode& joint_of(int n) const { return joints_.nodes()[static_cast<std::size_t>(n - 1)]; }

    /// Computes poses and arms, without p.
    /// @param y of JointTree
    void place(const double* y);
    /// Computes p of all nodes, after `place`.
    void find_p(const double* y);
    /// Computes velocities and the accelerations due to them alone, after `place`.
    void move(const double* y);
    /// Sets the inertia of every node to its own, and all wrenches to 0.
    /// @param length of a body in the metric of geometry [m]
    void set_inertias(Metric metric, double length = 1.0);
    /// Sets the inertia of every node to its own, by mass, and the wrenches to Q - M Ḃ u.
    /// @param forces Q, one per body of the mechanism
    void set_inertias_and_wrenches(std::span<const BodyForce> forces);
    /// Transfers a wrench from the centre of mass of node n to its root.
    Six at_root(int n, const Vec3& force, const Vec3& torque) const;
    /// Product of such a wrench with the acceleration of node n due to velocities alone.
    double drift_along(int n, const Six& on) const;
    /// Pass down: e from the wrenches of the nodes.
    void fold();
    /// Pass up: u̇ from e.
    void unfold();
    std::vector<double>& e() { return e_; }
    const std::vector<double>& e() const { return e_; }
    /// Sets e so that every joint, by itself, would move by `drawn`, in rad or in units of `length`. Needs
    /// the last inertias folded.
    /// @param drawn one number per velocity
    void set_forces(std::span<const double> drawn, double length);
    /// u̇ of the last `unfold`.
    const std::vector<double>& u_dot() const { return u_dot_; }

    /// Computes the accelerations B u̇ of the nodes for any u̇.
    void accelerate(const double* u_dot);

    /// Columns of E = Φq B F⁻ᵀ in which a row between nodes i and j has entries: the joints on the paths from
    /// both to the ground, with the common part once. (Φq B ends where the two paths meet; F⁻ᵀ does not.)
    std::vector<int> path(int i, int j) const;
    /// Computes e of a pair of wrenches on nodes i and j, and D⁻¹ e, in the order of the path. Needs the last
    /// inertias folded.
    /// @param on_i wrench at the root of node i; on_j likewise
    void respond(int i, int j, const Six& on_i, const Six& on_j, double* e, double* e_by_D) const;

private:
    /// Part of the paths from two nodes to the ground.
    enum class Way { from_i, from_j, first_of_both, both };
    /// Calls `f(n, way)` for every node n on the paths from nodes i and j to the ground, tips first.
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
    /// Computes sines and cosines of a share of the angle of every joint.
    void turn(double share, const double* y, std::vector<FourTurns>& turns) const;

    Registers registers_;
    JointTree joints_;
    std::vector<Node> nodes_;
    std::vector<int> turning_;      ///< nodes with a revolving joint
    std::vector<FourTurns> turns_;  ///< sines and cosines of their angles, in groups of four
    std::vector<FourTurns> half_turns_;
    std::vector<int> with_p_;  ///< nodes with Euler parameters of their own
    std::vector<double> e_;
    std::vector<double> u_dot_;
};

}  // namespace jw
