#pragma once

#include <vector>

#include "core/numerics/linear.hpp"

namespace jw {

/// Inverts a square matrix in place by Gauss-Jordan elimination, which skips the many entries of a Jacobian
/// that are 0: for inverses that are checked, as those of a proof are.
/// @param pivots memory of the elimination
/// @return false if the matrix is singular; it is spoilt then
bool invert_in_place(MatrixX& m, std::vector<Eigen::Index>& pivots);

}  // namespace jw
