#pragma once

#include <vector>

#include "core/system.hpp"

/// Free motions followed: does a null vector of Φq belong to a motion, or to a velocity only?
namespace jw {

struct FollowedMotion {
    std::vector<State> states;  ///< assembled, in the order of the motion, at least the state it started from
    int start = 0;              ///< where that is in `states`
    bool finite = false;        ///< false: instantaneous, no way leads on in either sense
};

/// Follows a free motion in both senses along the assembled states: a step along the tangent nearest to the
/// one before, then Newton.
///
/// Whether it is finite is told by the first step. The tangent promises a movement h; Newton brings that onto
/// Φ = 0 and leaves a movement m. Along a curve m/h tends to 1 as h shrinks, and a correction of less than a
/// third is asked for. Where branches cross, a vector between their tangents keeps a fixed part: a tenth is
/// enough. Where the null vector is a velocity only (bars in line), Newton goes all the way back: m is what Φ
/// of order h² hides below Newton's tolerance of 1e-13, a few 1e-7, and m/h is next to nothing. Asked for h,
/// h/4, h/16, h/64; none of them kept in either sense means instantaneous.
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
