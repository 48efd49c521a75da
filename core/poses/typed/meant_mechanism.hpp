#pragma once

#include <optional>
#include <vector>

#include "core/model/mechanism.hpp"

/// Overconstrained mechanisms that were typed with few digits. Their joints repeat each other only while
/// points and axes fit exactly: as typed they are locked, or fall apart under a driver, although a mechanism
/// within half a unit of the last digits moves.
namespace jw {

/// A number of a joint, known to half a unit of its last digit.
struct TypedNumber {
    /// Change of a vector of the geometry per unit of the number.
    struct Change {
        Vec3 JointGeometry::*vector = nullptr;
        Vec3 direction = Vec3::Zero();
    };
    int joint = 0;
    double half_unit = 0.0;
    std::vector<Change> vectors;
    double JointGeometry::*scalar = nullptr;  ///< in the place of vectors
};

/// Largest mechanism that is searched: decompositions of larger ones take longer than a reader should wait.
inline constexpr int kMostTypedBodies = 20;

/// Verdict, and the geometry of each joint of the mechanism that was meant, if it is told.
struct MeantMechanism {
    TypedVerdict verdict;
    std::vector<JointGeometry> geometry;
};

/// Searches for the mechanism that was meant: the poses of the motion that the nearly dependent equations
/// leave are found in least squares, then the smallest change of the numbers for which all equations hold at
/// all of them; other poses on the way check it.
/// @param numbers those known to their last digit; all others are exact
/// @return nothing where the digits make no difference to the rank, no motion is near, or more than
///         kMostTypedBodies move
std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers);

}  // namespace jw
