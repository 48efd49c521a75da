#pragma once

#include <vector>

#include "core/equations/system.hpp"

/// Finite and instantaneous free motions: whether a null vector of Φq belongs to a motion, or is a velocity
/// only.
namespace jw {

/// States along a free motion.
struct FollowedMotion {
    std::vector<State> states;  ///< assembled, in the order of the motion, at least the state it started from
    int start = 0;              ///< index of the start in `states`
    bool finite = false;        ///< false: instantaneous, no motion in either sense
};

/// Follows a free motion in both senses along the assembled states: a step along the tangent nearest to the
/// one before, then Newton's method.
///
/// The first step decides whether it is finite. The tangent predicts a movement h; Newton's method projects
/// it onto Φ = 0 and leaves a movement m. Along a curve m/h tends to 1 as h shrinks, and the correction must
/// be less than a third. Where branches cross, a vector between their tangents keeps a fixed part: a tenth is
/// enough. Where the null vector is a velocity only (bars in line), Newton's method returns all the way: m is
/// what Newton's tolerance of 1e-13 hides of a Φ of order h², a few 1e-7, and m/h is next to nothing. Tested
/// for h, h/4, h/16, h/64; if none of them is kept in either sense, the freedom is instantaneous.
///
/// @param state satisfies the constraints at time `t`, at which drivers stand still
/// @param direction columns of (r, ω') and θ with Φq direction = 0, as RankReport::free_motions; any size
/// @param steps at most this many in each sense; fewer where the motion ends
/// @param step_turn largest turn of a body per step [rad]; displacements count in sizes of the machine
/// @throws std::invalid_argument if `direction` has not the system's number of columns
FollowedMotion follow_free_motion(
    const System& system, const State& state, double t, const VectorX& direction, int steps,
    double step_turn);

}  // namespace jw
