#pragma once

#include "core/numerics/sparse_rows.hpp"
#include "core/rank.hpp"

/// The rank of large systems, from sparse factors instead of singular values.
namespace jw {

/// Of more columns (fifty bodies) singular values and free motions take longer than anybody waits unasked.
inline constexpr int kMostColumnsWithSpectrum = 300;

/// The same verdicts as analyse_rank, from a factorisation whose work grows with the bodies. Where its error
/// bounds do not prove what the singular values would say, these are computed after all.
/// @param jacobian the (r, ω') matrix at a state, as Assembler<OmegaLocal>::sparse_jacobian gives it
/// @param phi its residuals there
RankReport analyse_large_rank(const System& system, const SparseRows& jacobian, const VectorX& phi);

/// The one or the other by the number of columns.
/// @param spectrum true: singular values and free motions whatever that takes
RankReport analyse_rank_of_any_size(
    const System& system, const SparseRows& jacobian, const VectorX& phi, bool spectrum);

}  // namespace jw
