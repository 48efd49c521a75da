#pragma once

#include <array>
#include <vector>

#include "core/motion/loads.hpp"

/// Reactions of joints and drivers: Φqᵀ λ, joint by joint.
namespace jw {

/// Force and torque on body j of a joint, global; the opposite acts on body i at the same point.
struct Wrench {
    Vec3 force = Vec3::Zero();   ///< [N]
    Vec3 torque = Vec3::Zero();  ///< about the joint's point [N m]
};

/// Reaction of one joint or driver.
struct Reaction {
    int joint = -1;   ///< index in the mechanism, -1 for a driver
    int driver = -1;  ///< index in the mechanism, -1 for a joint
    int body_i = 0;
    int body_j = 0;
    Vec3 point = Vec3::Zero();  ///< the joint's point on body j, global [m]
    /// Columns: two directions perpendicular to the joint's axis (for a distance: its line) and the axis
    /// itself, global.
    Mat3 axes = Mat3::Identity();
    Wrench wrench;
    /// True if each component along `axes` is the same in every solution.
    std::array<bool, 3> force_unique{true, true, true};
    std::array<bool, 3> torque_unique{true, true, true};
    /// True if each component along the global axes x, y, z is the same in every solution.
    std::array<bool, 3> force_unique_global{true, true, true};
    std::array<bool, 3> torque_unique_global{true, true, true};
    /// Force or torque of a driver along its prescribed quantity [N, N m]: effort times rate is its power.
    double effort = 0.0;

    /// True if all components are the same in every solution.
    bool unique() const;
};

/// Reactions of a motion. If rows are redundant, joints can be braced against each other without any motion.
/// Then `reactions` is the solution with the smallest Σ |f|² + |n|² / ℓ² (ℓ: extent of the mechanism), which
/// depends neither on the form of the equations nor on the frames, and every solution is this one plus a
/// combination of `family`.
struct Reactions {
    std::vector<Reaction> reactions;  ///< of joints, then of drivers; none between two fixed bodies
    /// Orthonormal basis of the reactions that can be added; every member has one wrench per reaction.
    std::vector<std::vector<Wrench>> family;
    /// Part of M q̈ - Q that no reaction explains, divided by |M q̈| + |Q|: 0 for accelerations that satisfy
    /// the equations of motion.
    double residual = 0.0;
    /// Part of M q̈ - Q that no reaction explains, divided by the sizes of all loads by themselves: they may
    /// cancel each other.
    double residual_of_loads = 0.0;
    /// Bound on `residual` from the rounding of accelerations and wrenches and from the violation of the
    /// constraints. A larger residual means that the accelerations do not satisfy the equations of motion.
    double bound = 0.0;

    bool unique() const { return family.empty(); }
    /// True if rounding explains the residual.
    bool holds() const { return residual <= bound; }
};

/// Computes reactions from the wrenches M q̈ - Q that the joints must exert on every body, independent of how
/// the accelerations were found.
/// @param state of the centroidal frames, like the motions; satisfies the constraints at time `t` [s]
/// @param acceleration r̈ and ω̇' of every body
Reactions find_reactions(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& acceleration);

/// Reactions from state and velocity of the body frames as given. The acceleration is still that of the
/// centroidal frames, since that is the result of the equations of motion.
Reactions reactions_from_body_frames(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& centroidal_acceleration);

}  // namespace jw
