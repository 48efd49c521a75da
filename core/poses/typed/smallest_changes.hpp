#pragma once

#include <optional>

#include "core/numerics/linear.hpp"

namespace jw {

/// Smallest x, |x_k| <= 1, with |A x - b| up to `least_rest`. Entries that would be larger are set to ±1,
/// round after round.
/// @return nothing if there is none
std::optional<VectorX> smallest_changes(const MatrixX& A, const VectorX& b, double least_rest);

}  // namespace jw
