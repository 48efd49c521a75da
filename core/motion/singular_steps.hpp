#pragma once

#include <algorithm>
#include <cmath>

/// Thresholds with which integrators pass singular positions. Pivots here are relative to the regular pivot.
namespace jw {

/// Pivot below which a stage is near a singular position; its square root is a sixth.
inline constexpr double kNearSingular = 3e-2;
/// Pivot below which a stage is too near: an acceleration there is wrong by 1e-16 / pivot.
inline constexpr double kTooNear = 1e-6;
/// Factor of the length of the next attempt when a stage is too near.
inline constexpr double kDodge = 0.93;
/// Least length of a step through a singular position, as a share of the last regular one.
inline constexpr double kSmallestShare = 0.4;

/// Largest correction of a state, in scales of the motion, that leaves it on its branch. Where two branches
/// cross, their velocities differ by more, however near their positions are.
inline constexpr double kOneMotion = 1e-2;

/// Rounding of an acceleration near a singular position, relative to the square of the fastest rotation:
/// 1e-16 moves a pose across its branch by 1e-16 / δ, its velocity by 1e-16 / δ² and its acceleration by
/// 1e-16 / δ³, where δ² is the pivot.
inline double rounding_of_acceleration(double pivot) {
    constexpr double rounding = 1e-15;  // rounding of some tens of operations
    return rounding / (pivot * std::sqrt(pivot));
}

/// Largest error, in scales of the motion, with which a step through a singular position is accepted for any
/// tolerance. Up to this limit it is rounding, a thousand times that of an acceleration; a larger error is
/// one of the motion.
inline constexpr double kMostErrorThrough = 1e-2;
inline double most_error_through(double pivot) {
    constexpr double worst_of_many = 1e3;
    return std::min(kMostErrorThrough, worst_of_many * rounding_of_acceleration(pivot));
}

/// Largest correction of the end of such a step, in scales of the motion, that rounding explains: 1e-16 times
/// a condition of 1e3, divided by the smallest pivot. In loops whose lengths fit to a few digits only,
/// branches do not cross: a step across the gap ends off the constraints, and projecting it takes or adds
/// energy. Such a step is rejected, so that the motion is followed through the gap.
inline double most_correction_through(double pivot, double tolerance) {
    constexpr double least = 1e-6;
    constexpr double rounding = 1e-13;
    return std::min(kMostErrorThrough, std::max({tolerance, least, rounding / pivot}));
}

}  // namespace jw
