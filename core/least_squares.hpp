#pragma once

#include <memory>
#include <vector>

#include <Eigen/QR>

#include "core/assembler.hpp"
#include "core/numerics/sparse_qr.hpp"

/// Rank-revealing least squares for Φq x = b: redundant rows do no harm, missing rows give the shortest x.
namespace jw {

/// Sizes by which rows are divided and unknowns multiplied before they are compared (System::row_unit,
/// System::length_unit).
struct Scaling {
    VectorX row;     ///< one per row
    VectorX column;  ///< one per column
};
template <class C>
Scaling scaling_of(const System& system, bool normalisation_rows = true);

/// Up to so many columns (ten bodies) a dense factorisation is as quick as a sparse one, and pivots over all
/// rows.
inline constexpr int kMostDenseColumns = 60;

/// Φqᵀ P = Q R with column pivoting picks the independent equations first; the others are W times those.
/// Works in place after the first use: nothing is allocated as long as the size stays. Of more than
/// kMostDenseColumns columns the factors are sparse (numerics/sparse_qr.hpp): pivots are chosen within a
/// joint then, and work grows with the bodies instead of their cube.
class LeastSquares {
public:
    explicit LeastSquares(Scaling scaling);

    /// Factors `jacobian` (rows x columns as in the scaling).
    void compute(const SparseRows& jacobian);
    bool is_sparse() const { return sparse_ != nullptr; }

    /// Equations whose part independent of the ones before is above `relative_threshold` of the largest.
    int rank(double relative_threshold) const;

    /// Pivot k over the largest pivot, largest first, k < min(rows, columns): falls to 0 as rank is lost.
    double relative_pivot(int k) const;

    /// Shortest x (in scaled unknowns) among those with the smallest |Φq x - b| (scaled rows), taking the
    /// first `rank` pivots as independent.
    void solve(const VectorX& b, int rank, VectorX& x);

    /// λ with Φqᵀ λ nearest to `force`, zero for all but the first `rank` pivots: the multipliers that hold
    /// it.
    void solve_transposed(const VectorX& force, int rank, VectorX& lambda);

    /// Leaves of `x` (unknowns, not scaled) the part that the first `rank` pivots do not see: the free motion
    /// with Φq x = 0 that is nearest to it in scaled unknowns.
    void keep_free_part(int rank, VectorX& x);

private:
    void reflect(Eigen::Index k);
    void solve_lower(int rank, VectorX& c) const;
    void factor_sparsely(double threshold) const;
    void reach_rank(int rank) const;
    void solve_sparsely(const VectorX& b, VectorX& x);
    void spread_inconsistency(VectorX& c);

    Scaling scaling_;
    SparseRows rows_;                     ///< the sparse matrix, to be factored with other thresholds
    std::unique_ptr<SparseQr> sparse_;    ///< none where the factors are dense
    mutable std::vector<double> pivots_;  ///< of `sparse_`, largest first
    MatrixX transposed_;
    Eigen::ColPivHouseholderQR<MatrixX> qr_;
    VectorX c_;
    VectorX y_;
    MatrixX W_;
    MatrixX normal_;
    VectorX inconsistency_;
};

}  // namespace jw
