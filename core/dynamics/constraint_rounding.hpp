#pragma once

/// Which rows repeat others, and when Newton's rounds onto the constraints have reached rounding; the same
/// for all equations of motion.
namespace jw {

/// Rows that keep less than this share of themselves beside others repeat them, squared: far above rounding
/// (1e-15 times a condition of 1e3), far below what is left of the rows of sound joints (1e-3).
inline constexpr double kRepeats = 1e-9;
/// Residuals, by the sizes of their equations, that are rounding only.
inline constexpr double kExact = 1e-15;
/// From here on a round that brings little is the last.
inline constexpr double kNearlyExact = 1e-12;
/// Quadratic convergence: from the error of a step two or three rounds reach rounding.
inline constexpr int kMostRounds = 12;
/// Residual after a projection up to which equations are met; where more is left nothing meets them.
inline constexpr double kMet = 1e-9;
/// Residual up to which rows that were left out repeat the others: what a lesson was typed with, seven
/// digits, grown a thousand times on the way.
inline constexpr double kContradicts = 1e-3;
/// Equations left out because they repeat others hold as well as the numbers of a lesson were typed, seven
/// digits at least; where they are off by more they say something else.
inline constexpr double kRepeatsUpTo = 1e-6;
/// Residual from which rows that were left out are asked again, and the growth after which once more: a scene
/// that begins at a singular position leaves out some that have something to say later.
inline constexpr double kAskedFrom = 1e-6;
inline constexpr double kAskedAgain = 10.0;

/// @param worst residual of this round; @param last of the round before, infinite for the first
inline bool is_at_rounding(double worst, double last) {
    return worst <= kExact || (worst < kNearlyExact && worst > 0.5 * last);
}

}  // namespace jw
