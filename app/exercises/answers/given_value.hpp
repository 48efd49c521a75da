#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/numerics/linear.hpp"

/// Numbers, vectors and matrices as students write them.
namespace jw {

struct GivenValue {
    MatrixX value;        ///< in the unit that was asked for; a vector is a column
    std::string problem;  ///< why the text was not understood, and what was expected; empty if it was
};

/// Reads "0.5236", "1/3", "-sqrt(3)/2", "30 deg", "2,5", "[1, 2, 3] m", "[[1, 2], [3, 4]]", "1 2 3; 4 5 6".
/// Full-width and typographic signs stand for those of a keyboard. Functions: sqrt, sin, cos, tan, asin,
/// acos, atan, atan2, exp; pi and π. A unit after the answer is converted; a unit of another kind is a
/// problem.
/// @param unit     the unit asked for, may be empty
/// @param entries  number of expected numbers: "1,5" is one number or two
GivenValue read_given_value(std::string_view text, std::string_view unit, std::ptrdiff_t entries = 1);

}  // namespace jw
