#pragma once

#include <string>

#include "app/exercises/asked.hpp"

/// Values in formulas.
namespace jw {

/// A number as a formula: "3 \\cdot 10^{-5}".
std::string number_latex(double value);
/// A value as a formula, in decimals: a number, or a matrix in brackets.
std::string value_latex(const MatrixX& value);
/// A given symbol: "\mathbf{s}_i = [...]". Drawn values are rational: if their decimals do not end, a common
/// denominator stands before the matrix, "\frac{1}{7} [-2, -4, 2, -5]".
std::string given_latex(const GivenSymbol& symbol);

}  // namespace jw
