#pragma once

/// Thresholds for redundant rows and for the convergence of projections, shared by all equations of motion.
namespace jw {

/// Pivot below which a row is redundant: far above rounding (1e-15 times a condition of 1e3), far below the
/// pivots of sound joints (1e-3).
inline constexpr double kRepeats = 1e-9;
/// Residual, divided by the size of its equation, up to which it is only rounding.
inline constexpr double kRoundingOnly = 1e-15;
/// Residual below which an iteration that hardly improves it is the last one.
inline constexpr double kNearlyExact = 1e-12;
/// Iterations of a projection at most; convergence is quadratic, and two or three bring the error of a step
/// to rounding.
inline constexpr int kMostRounds = 12;
/// Residual after a projection up to which the equations count as satisfied; where more is left, no state
/// satisfies them.
inline constexpr double kMet = 1e-9;
/// Residual up to which rows left out count as consistent during a motion: the error of a lesson typed with
/// seven digits, grown a thousand times.
inline constexpr double kContradicts = 1e-3;
/// Residual up to which redundant equations count as consistent at the start: a lesson is typed with at least
/// seven digits. A larger one is a contradiction.
inline constexpr double kRepeatsUpTo = 1e-6;
/// Residual of the rows left out from which the rank is computed again, and the growth after which it is
/// computed once more: a scene that begins at a singular position leaves out rows that become independent
/// later.
inline constexpr double kAskedFrom = 1e-6;
inline constexpr double kAskedAgain = 10.0;

/// True if a projection has converged.
/// @param worst residual of this iteration
/// @param last residual of the previous one, infinite for the first
inline bool is_at_rounding(double worst, double last) {
    return worst <= kRoundingOnly || (worst < kNearlyExact && worst > 0.5 * last);
}

}  // namespace jw
