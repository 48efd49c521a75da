#pragma once

#include <optional>
#include <vector>

#include "core/poses/typed/typed_number.hpp"

/// Overconstrained mechanisms that were typed with few digits. Their joints are redundant only while points
/// and axes fit exactly: as typed they are locked, or do not stay together under a driver, although a
/// mechanism within half a unit of the last digits moves.
namespace jw {

/// Verdict, and the geometry of each joint: as meant if that mechanism was found, otherwise as typed.
struct MeantMechanism {
    TypedVerdict verdict;
    std::vector<JointGeometry> geometry;
    VectorX effects;  ///< effect of half a unit of each number on the conditions for a motion; 0: none
};

/// Searches each closed part of the mechanism for what was meant. The joints that may be redundant are
/// searched alone first, so that a loop takes the same time whatever it is connected to. A number of a pose
/// that acts in two closed parts is fitted in each of them separately.
/// @param numbers those known to their last digit; all others are exact
/// @return nothing if the digits do not affect the rank, if no motion is near, or if everything is too large
/// to decide: more than 25 moving bodies in doubt together, or a part of more than 300 columns
std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers);

}  // namespace jw
