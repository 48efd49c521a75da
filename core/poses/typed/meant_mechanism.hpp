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
/// first, so that a loop takes the time that it takes alone, whatever it hangs on. A number of a pose that
/// acts in two closed parts is fitted in each by itself.
/// @param numbers those known to their last digit; all others are exact
/// @return nothing where the digits make no difference to the rank, no motion is near, or all is too large to
///         tell: more than 25 moving bodies in doubt together, or a part of more than 300 columns
std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers);

}  // namespace jw
