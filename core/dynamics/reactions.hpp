#pragma once

#include <array>
#include <vector>

#include "core/dynamics/loads.hpp"

/// What the joints and drivers do to the bodies: Φqᵀ λ, read joint by joint.
namespace jw {

/// Force and torque on body j of a joint, global; body i gets the opposite at the same point.
struct Wrench {
    Vec3 force = Vec3::Zero();   ///< [N]
    Vec3 torque = Vec3::Zero();  ///< about the joint's point [N m]
};

struct Reaction {
    int joint = -1;   ///< index in the mechanism, -1 for a driver
    int driver = -1;  ///< index in the mechanism, -1 for a joint
    int body_i = 0;
    int body_j = 0;
    Vec3 point = Vec3::Zero();  ///< the joint's point on body j, global [m]
    /// Columns: two directions across the joint's axis (for a distance: its line) and the axis itself,
    /// global.
    Mat3 axes = Mat3::Identity();
    Wrench wrench;
    /// Which components along `axes` are the same in every answer.
    std::array<bool, 3> force_unique{true, true, true};
    std::array<bool, 3> torque_unique{true, true, true};
    /// Which components along the global axes x, y, z are.
    std::array<bool, 3> force_unique_global{true, true, true};
    std::array<bool, 3> torque_unique_global{true, true, true};
    /// Of a driver: force or torque with which it pushes what it prescribes, effort times rate is its power
    /// [N, N m].
    double effort = 0.0;

    bool unique() const;
};

/// Reactions that hold a motion. Where rows repeat each other the joints can be braced against each other
/// without moving anything: then `reactions` is the answer with the smallest Σ |f|² + |n|² / ℓ² (ℓ: extent of
/// the mechanism), which depends neither on the form of the equations nor on the frames, and every answer is
/// that one plus a combination of `family`.
struct Reactions {
    std::vector<Reaction> reactions;  ///< joints, then drivers; none between two fixed bodies
    /// Orthonormal basis of what can be added, one wrench per reaction in every member.
    std::vector<std::vector<Wrench>> family;
    /// What of M q̈ - Q no reaction explains, by |M q̈| + |Q|: 0 for accelerations that obey the equations of
    /// motion.
    double residual = 0.0;
    /// Of `residual`: rounding of accelerations and wrenches, and what a violation of the constraints leaves.
    /// More says that the accelerations do not obey the equations of motion.
    double bound = 0.0;

    bool unique() const { return family.empty(); }
    bool holds() const { return residual <= bound; }
};

/// From the wrenches M q̈ - Q that the joints must have put on every body, whichever way the accelerations
/// were found.
/// @param state satisfies the constraints at time `t` [s]; like the motions, of the centroidal frames
/// @param acceleration r̈ and ω̇' of every body
Reactions find_reactions(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& acceleration);

/// The same where state and velocity are those of the bodies' own frames; the acceleration is centroidal all
/// the same, since that is what the equations of motion give.
Reactions reactions_from_body_frames(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& centroidal_acceleration);

}  // namespace jw
