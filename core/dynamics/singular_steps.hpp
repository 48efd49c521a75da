#pragma once

#include <algorithm>
#include <cmath>

/// How integrators get past singular positions.
namespace jw {

/// Near one: the smallest pivot has fallen this much, its square root to a sixth.
inline constexpr double kNearSingular = 3e-2;
/// Too near for a stage: an acceleration there is wrong by 1e-16 / pivot.
inline constexpr double kTooNear = 1e-6;
/// A step one of whose stages lies too near is tried with another length.
inline constexpr double kDodge = 0.93;
/// A step through a singular position is at least this share of the last regular one.
inline constexpr double kSmallestShare = 0.4;

/// Change of a state, by the scales of the motion, that takes it back to the motion it was meant to be on.
/// Where two branches part, their velocities differ by more, however near their positions are.
inline constexpr double kOneMotion = 1e-2;

/// Rounding of an acceleration there, by the square of the fastest turning: 1e-16 moves a pose across its
/// branch by 1e-16 / δ, its velocity by 1e-16 / δ² and its acceleration by 1e-16 / δ³, where δ² is the pivot.
inline double rounding_of_acceleration(double pivot) {
    constexpr double rounding = 1e-15;  // of some tens of operations
    return rounding / (pivot * std::sqrt(pivot));
}

/// Error of a step, by the scales of the motion, up to which one through a singular position is taken
/// whatever its tolerance: it is rounding there, a thousand times that of an acceleration. Beyond, it is the
/// motion.
inline constexpr double kMostErrorThrough = 1e-2;
inline double most_error_through(double pivot) {
    constexpr double worst_of_many = 1e3;
    return std::min(kMostErrorThrough, worst_of_many * rounding_of_acceleration(pivot));
}

/// Correction of the end of such a step by the constraints, likewise, that rounding explains: 1e-16 times a
/// condition of 1e3, divided by the smallest pivot. Where the links of a loop fit to a few digits only, no
/// branch crosses another: a step across the gap ends beside the constraints, and moving it back takes or
/// adds energy. Then what is there is followed through the gap.
inline double most_correction_through(double pivot, double tolerance) {
    constexpr double least = 1e-6;
    constexpr double rounding = 1e-13;
    return std::min(kMostErrorThrough, std::max({tolerance, least, rounding / pivot}));
}

}  // namespace jw
