#pragma once

#include <optional>
#include <string_view>

#include "lessons/math/math.hpp"

/// Reads the notation of docs/mathematics.md, a subset of LaTeX.
namespace jw::math {

/// A mistake in a formula.
struct Problem {
    std::size_t at = 0;   ///< byte of the source
    std::string message;  ///< what is wrong; what was expected
    std::string hint;     ///< what to do, may be empty
};

struct Reading {
    Row row;  ///< as far as it could be read
    std::optional<Problem> problem;
};

/// Reads a formula without its dollar signs.
Reading read_math(std::string_view source);

/// Reads a formula that is written in the program's own source and must be right.
/// @throws std::invalid_argument with the message if it is wrong
Row own_math(std::string_view source);

}  // namespace jw::math
