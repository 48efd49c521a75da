#pragma once

#include "core/numerics/linear.hpp"

/// One-sided Jacobi method: rotations that make the columns of a matrix orthogonal to each other.
namespace jw {

/// Rotates the columns of `X` (r x c, r >= c, none of them zero or below 1e-140) in pairs until each pair is
/// orthogonal to rounding, |x_pᵀ x_q| <= √r 2⁻⁵² |x_p||x_q|, and applies the same rotations to the columns of
/// `J`.
/// @return false if 40 sweeps were not enough; 5 are usual
bool make_columns_orthogonal(MatrixX& X, MatrixX& J);

}  // namespace jw
