#pragma once

#include "core/linear.hpp"

/// Singular values of dense matrices, checked: every decomposition says how far its values can be off.
namespace jw {

/// A = U Σ Vᵀ of an m x n matrix, k = min(m, n).
///
/// `error` does not rest on the algorithm. With E = A − U Σ Vᵀ, δU = ‖UᵀU − I‖ and δV = ‖VᵀV − I‖,
///
///   |σ_i − true σ_i| <= ‖E‖ + σ_i ((1 + δU)(1 + δV) − 1)
///
/// (Weyl for E, Ostrowski for factors that are not quite orthogonal); E, δU and δV are measured by products
/// of matrices, and the rounding of those products is part of the bound.
/// @source Horn and Johnson, Matrix Analysis, 7.3.5 and 4.5.9
struct Svd {
    VectorX sigma;               ///< k, largest first
    MatrixX U;                   ///< m x k, orthonormal columns
    MatrixX V;                   ///< n x n, orthogonal; the columns behind the rank span the null space
    double misfit = 0.0;         ///< ‖A − U Σ Vᵀ‖, Frobenius
    double orthogonality = 0.0;  ///< the larger of ‖UᵀU − I‖ and ‖VᵀV − I‖, Frobenius
    double norm_defect = 0.0;    ///< |Σ σ² − ‖A‖²| / ‖A‖², 0 for A = 0
    double error = 0.0;          ///< no singular value is off by more than this
    /// False if one of the three above is beyond rounding: then `error` is large, and what follows from the
    /// values may not be said. Also false if A is not finite; then `error` is infinite.
    bool sound = true;

    Eigen::Index rank(double threshold) const;  ///< how many are larger
};

/// One-sided Jacobi after two QR decompositions, the first with column pivoting. Relative accuracy: where
/// the columns (m >= n; else the rows) of A are scaled to one length, the relative error of every singular
/// value is rounding times the condition of what remains, however different the lengths were. Scaled by
/// powers of two only, one thread, no library of the machine: equal numbers everywhere.
/// @source Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, SIAM J. Matrix Anal. Appl. 29
///         (2008), algorithms 1 and 2; the algorithm of LAPACK's dgejsv
Svd svd_of(const MatrixX& matrix);

/// Measures misfit, orthogonality, norm defect and error of `svd`, wherever its U, σ and V come from, and
/// judges them; svd_of has done it.
void check_svd(const MatrixX& matrix, Svd& svd);

}  // namespace jw
