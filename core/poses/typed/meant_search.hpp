#pragma once

#include <optional>

#include "core/poses/typed/typed_number.hpp"

/// Searches for the mechanism that was meant, in one closed part of a mechanism.
namespace jw {

/// State near the start at which the equations hold, or hold best.
State best_start(const System& system);

/// Joints whose rank may change with their numbers by less than half a unit of the last digits.
struct RankDoubt {
    State start;   ///< state in which the equations hold best, as typed
    int rank = 0;  ///< without the singular values that changes of the digits may explain
    int rank_as_typed = 0;
    std::vector<int> joints;  ///< joints that may be redundant, ascending
};

/// Doubt about the rank of a closed part.
/// @param numbers those known to their last digit; all others are exact
/// @return nothing if the digits do not affect the rank, or if too many bodies move to decide
std::optional<RankDoubt> find_doubt(const Mechanism& mechanism, const std::vector<TypedNumber>& numbers);

/// Result of the search in a closed part.
struct MeantPart {
    /// Change of the conditions for a motion by half a unit of a number.
    struct Effect {
        int number = 0;  ///< TypedNumber::index
        double size = 0.0;
    };
    TypedVerdict verdict;
    std::vector<JointGeometry> geometry;  ///< of each joint; as typed if no mechanism was found
    std::vector<Effect> effects;          ///< of each number
};

/// Finds the poses of the motion that the nearly dependent equations leave in least squares, then the
/// smallest change of the numbers for which all equations hold at all of them; other poses on the way check
/// it.
/// @return nothing if no motion is near, or if the misfit has another cause than digits
std::optional<MeantPart> find_meant(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers, const RankDoubt& doubt);

}  // namespace jw
