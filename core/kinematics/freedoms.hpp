#pragma once

#include <optional>
#include <vector>

#include "core/equations/system.hpp"
#include "core/kinematics/departure.hpp"

/// Free motions: whether a null vector of Φq belongs to a motion, or is only a velocity.
namespace jw {

/// Verdict on a null vector of Φq.
enum class FreedomVerdict {
    finite,       ///< it is the velocity of a motion, proved over kProvedLength
    first_order,  ///< not the velocity of a motion; FollowedMotion::departure says how it leaves Φ = 0
    cannot_tell,
};

/// Length over which a motion is proved [rad, or sizes of the machine].
inline constexpr double kProvedLength = 0.2;

/// Default length of the steps by which a motion is followed [rad, or sizes of the machine].
inline constexpr double kFreedomStep = 0.03;

/// Verdict on a free motion, and its departure from the equations.
struct FreedomJudgement {
    FreedomVerdict verdict = FreedomVerdict::cannot_tell;
    std::optional<Departure> departure;  ///< if it is of first order only
    /// True if the motion is of first order, but another motion through the followed states leads away from
    /// the start and is proved.
    bool has_motion_beside = false;

    bool is_finite() const { return verdict == FreedomVerdict::finite; }
};

/// States along a free motion.
struct FollowedMotion : FreedomJudgement {
    std::vector<State> states;  ///< assembled, in the order of the motion; at least the start
    int start = 0;              ///< index of the start in `states`
};

/// Follows a free motion in both directions along the assembled states: a step along the tangent nearest to
/// the previous one, then Newton's method.
///
/// The motion is finite if it does not leave the equations at any order (find_departure), and if StepProof
/// proves, in at least one direction, that a path of length kProvedLength leads along the first states; what
/// is left free follows the cubic path. All equations hold at the ends of all steps to 1e-11 of their unit,
/// or to ten times their residual at the start. A step that cannot be proved is halved. From a start where
/// branches cross, no step can be proved: there a step of kCrossing is taken if the cubic path along
/// `direction` satisfies the equations.
///
/// States are also given for a motion of first order: where branches cross, a vector between their tangents
/// leads onto one of them. The tangent predicts a movement h; Newton's method projects it onto Φ = 0 and
/// leaves a movement m. Along a curve, m/h tends to 1 as h shrinks, and the correction must be less than a
/// third; between branches m stays a fixed part of h, and a tenth is enough. Tried for h, h/4, h/16, h/64.
///
/// @param state satisfies the constraints at time `t`, at which drivers stand still
/// @param direction columns of (r, ω') and θ with Φq direction = 0, as RankReport::free_motions; any size
/// @param steps at most this many in each direction; fewer where the motion ends
/// @param step_turn largest turn of a body per step [rad]; displacements count in sizes of the machine.
///        No motion is judged finite unless `steps` of this length add up to kProvedLength
/// @throws std::invalid_argument if `direction` does not have the system's number of columns
FollowedMotion follow_free_motion(
    const System& system, const State& state, double t, const VectorX& direction, int steps,
    double step_turn);

/// Judgement on a free motion, which is followed by steps of kFreedomStep and only as far as needed.
FreedomJudgement judge_free_motion(
    const System& system, const State& state, double t, const VectorX& direction);

}  // namespace jw
