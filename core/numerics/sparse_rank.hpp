#pragma once

#include <vector>

#include "core/numerics/sparse_qr.hpp"

/// Rank of a large Φq without its singular values, with bounds that say how sure it is.
namespace jw {

/// A row as a combination of rows that count.
struct SparseCombination {
    int row = 0;
    std::vector<int> rows;
    std::vector<double>
        coefficients;     ///< of scaled rows; row = Σ coefficient * row, what is negligible left out
    double misfit = 0.0;  ///< largest entry of the difference, scaled
};

/// Singular values are those of D⁻¹ Φq S, with row sizes D and column sizes S.
struct SparseRank {
    int rank = 0;
    double threshold = 0.0;      ///< absolute; singular values up to it count as zero
    double largest = 0.0;        ///< σ_1, by power iteration
    double last = 0.0;           ///< σ_r, by inverse iteration
    double last_but_one = 0.0;   ///< σ_(r-1), likewise
    double last_at_least = 0.0;  ///< a bound: σ_r is no smaller
    double next_at_most = 0.0;   ///< a bound: σ_(r+1) is no larger
    std::vector<int> repeating;  ///< rows that repeat rows of their group or of groups before, ascending
    std::vector<SparseCombination> combinations;  ///< one per repeating row

    /// True where the bounds prove what the singular values would say: σ_r above the threshold, σ_(r+1) not.
    bool is_proved() const { return next_at_most <= threshold && (rank == 0 || last_at_least > threshold); }
};

/// @param group_of_row rows that stay together when dependence is told, ascending from 0: a later group
/// repeats
///        earlier ones, and in a group the row with the largest new part counts first
/// @param relative_threshold times max(1, σ_1) is the threshold
SparseRank sparse_rank_of(
    const SparseRows& rows, const VectorX& row, const VectorX& column, std::vector<int> group_of_row,
    double relative_threshold);

}  // namespace jw
