#pragma once

#include <array>

#include "core/model/joint_types.hpp"

/// Choice of two of the three equations of p1 and p2, and its reason.
///
/// The two kept rows of s̃_i v have singular values 1 and |s_drop| (unit s_i, aligned), so the condition
/// number of a pair is 1/|s_drop|: drop the equation where the *global* |s_i| is largest. The choice is kept
/// until the dropped component falls under 0.8 of the largest; the condition stays below √3 / 0.8 = 2.17 and
/// noise near (1,1,1) causes no switching. It never changes inside a Newton solve.
/// @source slide 5; docs/notation.md
namespace jw {

inline constexpr double kKeepRatio = 0.8;

/// Index of the equation to drop for the axis `s_i` (global, any length, not zero).
/// @param previous index dropped so far, -1 if none
int choose_dropped(const Vec3& s_i, int previous);

/// Dropped index that a form forces, -1 if it forces none.
int forced_drop(ParallelForm form);

/// Reason for a choice, as the lesson shows it.
struct RowChoice {
    ParallelForm form = ParallelForm::rule;
    int dropped = -1;         ///< 0, 1, 2 = x, y, z; -1: none (all three, or the n1 / n2 pair)
    int previous = -1;        ///< index dropped before, -1 if none
    unsigned taken_out = 0;   ///< bit k: equation k was removed by hand
    Vec3 s_i = Vec3::Zero();  ///< global axis, unit
    /// Condition number (largest divided by smallest singular value) of the two rows left when x, y or z is
    /// dropped, of their (r, ω') matrix over the moving bodies; infinite when the pair has lost rank.
    std::array<double, 3> pair_condition{};
    /// Condition number of the rows kept now; for all three rows, of their two nonzero directions. Infinite
    /// if none is left.
    double form_condition = 0.0;
};

}  // namespace jw
