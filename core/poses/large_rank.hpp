#pragma once

#include "core/numerics/sparse_rows.hpp"
#include "core/poses/rank.hpp"

/// Rank of large systems from sparse factors instead of singular values.
namespace jw {

/// Number of columns (fifty bodies) above which singular values and free motions take too long to be computed
/// without a request.
inline constexpr int kMostColumnsWithSpectrum = 300;

/// Finds the verdicts of analyse_rank by a factorisation whose work grows with the bodies, not with their
/// cube. If its error bounds do not prove the verdict of the singular values, these are computed as well.
/// @param jacobian the (r, ω') matrix at a state, as Assembler<OmegaLocal>::sparse_jacobian gives it
/// @param phi residuals at that state
RankReport analyse_large_rank(const System& system, const SparseRows& jacobian, const VectorX& phi);

/// Quickly finds, for many poses, the verdict and the first and last singular value that counts: no redundant
/// rows, and no free motions of more than ten bodies. Up to kMostColumnsWithSpectrum columns, the two values
/// are right to six digits; above, as in analyse_large_rank.
RankReport analyse_rank_verdict(const System& system, const SparseRows& jacobian, const VectorX& phi);

/// Calls analyse_rank or analyse_large_rank depending on the number of columns.
/// @param spectrum true: compute singular values and free motions at any size
RankReport analyse_rank_of_any_size(
    const System& system, const SparseRows& jacobian, const VectorX& phi, bool spectrum);

}  // namespace jw
