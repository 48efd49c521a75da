#pragma once

#include <vector>

#include "core/model/mechanism.hpp"

/// Parts of a mechanism whose joints form closed loops with each other, but none with the rest: only joints
/// of the same part can be redundant with each other, and no part restrains the motion of another.
namespace jw {

/// Part whose joints stay connected if any one of its bodies is removed.
struct ClosedPart {
    std::vector<int> joints;  ///< indices in the mechanism, ascending
    int base = 0;             ///< body that connects the part to the rest
};

/// The parts with loops that these joints form; all fixed bodies count as one.
/// @source Hopcroft and Tarjan, Efficient algorithms for graph manipulation, Communications of the ACM 16
///         (1973): biconnected components
std::vector<ClosedPart> closed_parts(const Mechanism& mechanism, const std::vector<int>& joints);

/// The mechanism with only the joints of a part, in which the base and all other bodies are fixed.
Mechanism alone(const Mechanism& mechanism, const ClosedPart& part);

}  // namespace jw
