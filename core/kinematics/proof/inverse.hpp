#pragma once

#include <vector>

#include "core/numerics/linear.hpp"

namespace jw {

/// Inverts a square matrix in place by Gauss-Jordan elimination, which skips the many zero entries of a
/// Jacobian. Only for inverses that are checked afterwards, as those of a proof are.
/// @param pivots memory of the elimination
/// @return false if the matrix is singular; its content is then lost
bool invert_in_place(MatrixX& m, std::vector<Eigen::Index>& pivots);

}  // namespace jw
