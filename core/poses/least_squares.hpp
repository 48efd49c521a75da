#pragma once

#include <memory>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/sparse_qr.hpp"

/// Rank-revealing least squares for Φq x = b: redundant rows do no harm, missing rows give the minimum-norm
/// x.
namespace jw {

/// Row and column scaling: sizes by which rows are divided and unknowns multiplied before they are compared
/// (System::row_unit, System::length_unit).
struct Scaling {
    VectorX row;     ///< one per row
    VectorX column;  ///< one per column

    /// Largest |Φ| divided by the size of its row; 0 without rows.
    double residual_of(const VectorX& phi) const {
        return phi.size() == 0 ? 0.0 : phi.cwiseQuotient(row).cwiseAbs().maxCoeff();
    }
};
template <class C>
Scaling scaling_of(const System& system, bool normalisation_rows = true);

/// Number of columns (ten bodies) up to which a dense factorisation is as fast as a sparse one, and pivots
/// are chosen among all rows.
inline constexpr int kMostDenseColumns = 60;

/// Solver by Φqᵀ P = Q R with column pivoting, which picks the independent equations first; the others are W
/// times those. Works in place after the first use: nothing is allocated while the size stays the same. Above
/// kMostDenseColumns columns, the factors are sparse (numerics/sparse_qr.hpp): pivots are then chosen within
/// a joint, and work grows with the bodies instead of their cube.
class LeastSquares {
public:
    explicit LeastSquares(Scaling scaling);

    /// Factors `jacobian` [rows x columns], sized as the scaling.
    void compute(const SparseRows& jacobian);
    bool is_sparse() const { return sparse_ != nullptr; }

    /// Number of equations whose remainder after removal of earlier ones is above `relative_threshold` of the
    /// largest.
    int rank(double relative_threshold) const;

    /// Pivot k divided by the largest pivot, in descending order, k < min(rows, columns): falls to 0 as rank
    /// is lost.
    double relative_pivot(int k) const;

    /// Minimum-norm x (in scaled unknowns) among those with the smallest |Φq x - b| (scaled rows), with the
    /// first `rank` pivots as independent.
    void solve(const VectorX& b, int rank, VectorX& x);

    /// Multipliers λ with Φqᵀ λ nearest to `force`, zero except for the first `rank` pivots.
    void solve_transposed(const VectorX& force, int rank, VectorX& lambda);

    /// Projects `x` (unknowns, not scaled) onto the free motions of the first `rank` pivots: the nearest one
    /// with Φq x = 0, in scaled unknowns.
    void keep_free_part(int rank, VectorX& x);

private:
    void reflect(Eigen::Index k);
    void solve_lower(int rank, VectorX& c) const;
    void factor_sparsely(double threshold) const;
    void reach_rank(int rank) const;
    void solve_sparsely(const VectorX& b, VectorX& x);
    void spread_inconsistency(VectorX& c);

    Scaling scaling_;
    SparseRows rows_;                     ///< the sparse matrix, kept for factoring with other thresholds
    std::unique_ptr<SparseQr> sparse_;    ///< empty where the factors are dense
    mutable std::vector<double> pivots_;  ///< pivots of `sparse_`, largest first
    MatrixX transposed_;
    Eigen::ColPivHouseholderQR<MatrixX> qr_;
    VectorX c_;
    VectorX y_;
    MatrixX W_;
    MatrixX normal_;
    VectorX inconsistency_;
};

}  // namespace jw
