#pragma once

#include <optional>

#include "core/poses/branches.hpp"
#include "core/poses/contradiction.hpp"

/// Diagnosis of a position that could not be found, beyond what Newton-Raphson reports.
namespace jw {

/// Cause of a failure of position analysis.
enum class FailureCause {
    cannot_close,   ///< the equations contradict each other: a closest fit was found, and it is not zero
    wrong_branch,   ///< only solutions with anti-parallel axes or half-turned sides were found
    singular,       ///< the iteration ended at a pose where independent equations are lost
    turning_point,  ///< it is proved that the motion turns back at `t`: no pose of this branch lies beyond
    likely_turning_point,  ///< the same, not proved
    no_value,              ///< a formula has no value, or no derivatives, at the start pose
    undecided,       ///< branches are so near to each other at `t` that rounding hides which one continues
    no_convergence,  ///< none of the above could be shown
};

/// Failure of position analysis, with the closest fit if one was found.
struct PositionFailure {
    FailureCause cause = FailureCause::no_convergence;
    int row = 0;                           ///< row with the largest residual at the closest fit
    double value = 0.0;                    ///< Φ of that row there
    double residual = 0.0;                 ///< largest |Φ|, scaled
    double smallest_singular_value = 0.0;  ///< relative to the largest, at the closest fit
    int iterations = 0;
    std::optional<WrongBranch> branch;
    double t = 0.0;  ///< time for which the position was sought [s]
    std::optional<Contradiction> contradiction = std::nullopt;  ///< contradicting parts, if they were found
};

/// Diagnoses a Newton run from `start` that ended at `reached` without converging: whether an equation has no
/// value at `start`; or whether `reached`, or the state to which damped steps from `start` lead, is a closest
/// fit of parts that cannot meet.
PositionFailure diagnose(
    const System& system, const State& start, const State& reached, double t, int iterations);

}  // namespace jw
