#pragma once

#include <vector>

#include "core/numerics/sparse_qr.hpp"

/// Rank of a large Φq without its singular values, with bounds that can prove it.
namespace jw {

/// Redundant row as a combination of independent rows.
struct SparseCombination {
    int row = 0;
    std::vector<int> rows;
    std::vector<double>
        coefficients;     ///< of scaled rows; row = Σ coefficient * row, negligible terms left out
    double misfit = 0.0;  ///< norm of the difference from these terms, scaled
    double bound = 0.0;   ///< bound of `misfit` from σ_(r+1) and rounding
};

/// Rank verdict. Singular values are those of D⁻¹ Φq S, with row sizes D and column sizes S.
struct SparseRank {
    int rank = 0;
    double threshold = 0.0;      ///< absolute threshold; singular values up to it count as zero
    double largest = 0.0;        ///< σ_1, by power iteration
    double last = 0.0;           ///< σ_r, by inverse iteration
    double last_but_one = 0.0;   ///< σ_(r-1), likewise
    double last_at_least = 0.0;  ///< lower bound of σ_r
    double next_at_most = 0.0;   ///< upper bound of σ_(r+1)
    std::vector<int> repeating;  ///< redundant rows, ascending; see group_of_row below
    std::vector<SparseCombination> combinations;  ///< one per redundant row

    /// True if the bounds prove the verdict of the singular values: σ_r above the threshold, σ_(r+1) not.
    bool is_proved() const { return next_at_most <= threshold && (rank == 0 || last_at_least > threshold); }
};

/// @param group_of_row rows that stay together when dependence is determined, ascending from 0: a later group
/// depends on earlier ones, and within a group the row with the largest remainder comes first
/// @param relative_threshold threshold divided by max(1, σ_1)
SparseRank sparse_rank_of(
    const SparseRows& rows, const VectorX& row, const VectorX& column, std::vector<int> group_of_row,
    double relative_threshold);

}  // namespace jw
