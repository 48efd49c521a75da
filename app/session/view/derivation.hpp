#pragma once

#include <optional>
#include <string>

#include "app/session/story/story.hpp"

/// Derivation of an entry of Φq.
namespace jw {

/// The block that an entry belongs to, with numbers for its symbols.
struct Derivation {
    std::string formula;  ///< "\Phi_{...} = ...", as docs/mathematics.md says
    std::string numbers;  ///< its right side with matrices of numbers for its symbols
    std::string block;    ///< its value
    double entry = 0.0;   ///< as the formula gives it
    std::string row;      ///< the row of the block with the entry: "row x: (0, 0.8, 0.6)"
};

/// @param row of the step's system
/// @param column of Φq in these coordinates
/// @return nothing for drivers, screws, pairs, normalisation and artificial coordinates, which have no such
/// block
std::optional<Derivation> derivation_of(const Step& step, CoordinateChoice coordinates, int row, int column);

}  // namespace jw
