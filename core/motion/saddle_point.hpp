#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/rank.hpp"

/// Dense linear system of slides 24 and 25.
namespace jw {

/// Relative threshold for independent rows at a state with this residual (scaled), see rank.hpp. A state that
/// is not assembled says nothing about redundancy.
inline double rank_threshold(double residual) {
    return residual <= kAssembledResidual ? std::max(kRankThreshold, kErrorFactor * residual)
                                          : kRankThreshold;
}

/// Solves
///
///   | M   Φqᵀ | |  x |   | f |
///   | Φq   0  | | -λ | = | b |
///
/// by Gaussian elimination with pivoting, for accelerations, velocities and displacements alike, over
/// independent rows. M may be singular (a screw's θ has no mass, nor has the length of p) provided every free
/// motion has kinetic energy. The condition of Φq enters once, not squared as in Φq M⁻¹ Φqᵀ, and masses may
/// be far apart: pivoting decides whether a body follows its forces or its constraints.
class SaddlePoint {
public:
    explicit SaddlePoint(Scaling scaling);

    /// Chooses rows by QR with column pivoting: a row counts if its remainder after removal of earlier rows
    /// is above `relative_threshold` of the largest (scaled rows). @return true if the choice changed
    bool choose_rows(const MatrixX& jacobian, double relative_threshold);
    /// Kept rows, the most independent first.
    const std::vector<int>& kept() const { return kept_; }
    /// Restores an earlier choice.
    void keep(std::vector<int> rows) { kept_ = std::move(rows); }

    /// @param mass [columns x columns], symmetric, positive semidefinite
    void factor(const MatrixX& mass, const MatrixX& jacobian);
    /// @param lambda one per row; 0 for those left out
    void solve(const VectorX& f, const VectorX& b, VectorX& x, VectorX& lambda) const;

    /// Smallest squared sine of the angle between a row and those before it.
    double smallest_pivot() const { return smallest_pivot_; }

private:
    Scaling scaling_;
    std::vector<int> kept_;
    MatrixX whole_;  ///< whole matrix in scaled unknowns and rows
    Eigen::PartialPivLU<MatrixX> lu_;
    double smallest_pivot_ = 1.0;
};

}  // namespace jw
