#pragma once

#include "core/numerics/linear.hpp"

/// Singular value decomposition of dense matrices, with a bound on the error of the values.
namespace jw {

/// A = U Σ Vᵀ of an m x n matrix, k = min(m, n).
///
/// The bound `error` does not depend on the algorithm. With E = A − U Σ Vᵀ, δU = ‖UᵀU − I‖ and δV = ‖VᵀV −
/// I‖,
///
///   |σ_i − true σ_i| <= ‖E‖ + σ_i ((1 + δU)(1 + δV) − 1)
///
/// (Weyl for E, Ostrowski for factors that are nearly orthogonal); E, δU and δV are measured by matrix
/// products, and the rounding of those products is part of the bound.
/// @source Horn and Johnson, Matrix Analysis, 7.3.5 and 4.5.9
struct Svd {
    VectorX sigma;               ///< k singular values, largest first
    MatrixX U;                   ///< m x k, orthonormal columns
    MatrixX V;                   ///< n x n, orthogonal; the columns after the rank span the null space
    double misfit = 0.0;         ///< ‖A − U Σ Vᵀ‖, Frobenius
    double orthogonality = 0.0;  ///< the larger of ‖UᵀU − I‖ and ‖VᵀV − I‖, Frobenius
    double norm_defect = 0.0;    ///< |Σ σ² − ‖A‖²| / ‖A‖², 0 for A = 0
    double error = 0.0;          ///< bound on the error of every singular value
    /// False if one of the three measures above exceeds rounding: then `error` is large, and the values allow
    /// no verdict. Also false if A is not finite; then `error` is infinite.
    bool sound = true;

    Eigen::Index rank(double threshold) const;  ///< number of singular values above it
};

/// Computes the decomposition by one-sided Jacobi after two QR decompositions, the first with column
/// pivoting. High relative accuracy: if the columns (m >= n; otherwise the rows) of A are scaled to unit
/// length, the relative error of every singular value is rounding times the condition of the scaled matrix,
/// for any original lengths. Scaling is by powers of two only; one thread, no library of the machine, so
/// results are bit-identical everywhere.
/// @source Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, SIAM J. Matrix Anal. Appl. 29
///         (2008), algorithms 1 and 2; the algorithm of LAPACK's dgejsv
Svd svd_of(const MatrixX& matrix);

/// Measures misfit, orthogonality, norm defect and error of `svd`, independently of how its U, σ and V were
/// found, and sets `sound`; svd_of has called it.
void check_svd(const MatrixX& matrix, Svd& svd);

}  // namespace jw
