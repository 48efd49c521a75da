#pragma once

#include <array>

#include "core/model/joint_types.hpp"

/// Choice of two of the three equations of p1 and p2, and its reason.
///
/// The two kept rows of s̃_i v have singular values 1 and |s_drop| (unit s_i, aligned), so the condition
/// number of a pair is 1/|s_drop|: the equation of the largest component of the *global* s_i is left out. The
/// choice is kept until that component falls below 0.8 of the largest; the condition stays below √3 / 0.8 =
/// 2.17, and noise near (1,1,1) causes no switching. The choice never changes inside a Newton solve.
/// @source slide 5; docs/notation.md
namespace jw {

inline constexpr double kKeepRatio = 0.8;

/// Index of the equation to leave out for the axis `s_i` (global, any length, not zero).
/// @param previous index left out so far, -1 if none
int choose_dropped(const Vec3& s_i, int previous);

/// Index of the equation that a form prescribes to leave out, -1 if it prescribes none.
int forced_drop(ParallelForm form);

/// Reason for a choice, as the lesson shows it.
struct RowChoice {
    ParallelForm form = ParallelForm::rule;
    int dropped = -1;         ///< 0, 1, 2 = x, y, z; -1: none (all three, or the n1 / n2 pair)
    int previous = -1;        ///< index left out before, -1 if none
    unsigned taken_out = 0;   ///< bit k: equation k is taken out by hand
    Vec3 s_i = Vec3::Zero();  ///< global axis, unit
    /// Condition number (largest divided by smallest singular value) of the two rows that remain without x, y
    /// or z, in the (r, ω') columns of the moving bodies; infinite if the pair has lost rank.
    std::array<double, 3> pair_condition{};
    /// Condition number of the rows kept now; for all three rows, of their two nonzero directions. Infinite
    /// if no row is left.
    double form_condition = 0.0;
};

}  // namespace jw
