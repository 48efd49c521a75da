#pragma once

#include <algorithm>
#include <cmath>

#include "core/numerics/linear.hpp"

/// Singular values to 19 digits, by the simplest method.
namespace jw::test {

using MatrixL = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Hestenes' method without any preparation: pairs of columns are rotated until all are orthogonal, then
/// their norms are the singular values. No QR, no scaling, no vectors, nothing of core.
/// @source Hestenes, Inversion of matrices by biorthogonalization, J. SIAM 6 (1958)
inline VectorX long_double_singular_values(const MatrixX& matrix) {
    MatrixL A = matrix.rows() < matrix.cols() ? MatrixL(matrix.transpose().cast<long double>())
                                              : MatrixL(matrix.cast<long double>());
    const long double tolerance = 1e-18L * std::sqrt(static_cast<long double>(A.rows()));
    bool rotated = true;
    for (int round = 0; rotated && round < 60; ++round) {
        rotated = false;
        for (Eigen::Index p = 0; p < A.cols(); ++p) {
            for (Eigen::Index q = p + 1; q < A.cols(); ++q) {
                const long double alpha = A.col(p).squaredNorm();
                const long double beta = A.col(q).squaredNorm();
                const long double gamma = A.col(p).dot(A.col(q));
                if (std::abs(gamma) <= tolerance * std::sqrt(alpha) * std::sqrt(beta)) { continue; }
                rotated = true;
                // the smaller of the two angles: near a right angle a cosine has no digits for graded columns
                const long double half = 0.5L * (alpha - beta) / gamma;
                const long double tangent = 1.0L / (half + std::copysign(std::hypot(half, 1.0L), half));
                const long double c = 1.0L / std::hypot(1.0L, tangent);
                const long double s = c * tangent;
                const Eigen::Matrix<long double, Eigen::Dynamic, 1> turned = c * A.col(p) + s * A.col(q);
                A.col(q) = c * A.col(q) - s * A.col(p);
                A.col(p) = turned;
            }
        }
    }
    VectorX sigma = A.colwise().norm().transpose().cast<double>();
    std::ranges::sort(sigma, std::ranges::greater{});
    return sigma;
}

}  // namespace jw::test
