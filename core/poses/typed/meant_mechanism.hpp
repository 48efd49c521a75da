#pragma once

#include <optional>
#include <vector>

#include "core/poses/typed/typed_number.hpp"

/// Overconstrained mechanisms that were typed with few digits. Their joints repeat each other only while
/// points and axes fit exactly: as typed they are locked, or fall apart under a driver, although a mechanism
/// within half a unit of the last digits moves.
namespace jw {

/// Verdict, and the geometry of each joint: that of the mechanism that was meant where it is told, else as
/// typed.
struct MeantMechanism {
    TypedVerdict verdict;
    std::vector<JointGeometry> geometry;
    VectorX effects;  ///< of half a unit of each number on what decides; 0 where it plays no part
};

/// Searches each closed part of the mechanism for what was meant, the joints that may repeat each other alone
/// first: loops that hang on each other, or in a larger one, take the time of each.
/// @param numbers those known to their last digit; all others are exact
/// @return nothing where the digits make no difference to the rank, or no motion is near
std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers);

}  // namespace jw
