#pragma once

#include <string>

#include "core/numerics/linear.hpp"

/// Numbers in the notation of docs/mathematics.md.
namespace jw {

/// "0.25", "1.2 \cdot 10^{-7}"
std::string number_markup(double value, int digits = 4);

/// A matrix in brackets; a matrix with one entry is a number. If it has more than eight rows or columns, its
/// size in words, in \text.
std::string matrix_markup(const MatrixX& values, int digits = 4);

}  // namespace jw
