#include "core/numerics/svd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/numerics/jacobi.hpp"

namespace jw {

namespace {

constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon();
/// Pivots up to this share of the largest entry count as 0: squares of columns would underflow.
constexpr double kVanished = 1e-140;
/// Errors of stable decompositions are a few roundings per row and column; wrong results are off by many
/// orders of magnitude more. Measured over 9000 Jacobians and small random matrices: up to 3.2.
constexpr double kRoundings = 30.0;

/// Power of two near a value: dividing by it is exact.
double power_of_two_near(double value) { return std::ldexp(1.0, std::ilogb(value)); }

struct Factors {
    VectorX sigma;
    MatrixX left;   ///< rows x left_columns
    MatrixX right;  ///< columns x columns
};

/// Columns of `X` divided by their norms, and the norms, largest first; the columns of `J` in that order.
struct Spectrum {
    VectorX sigma;
    MatrixX W;
    MatrixX J;
};
Spectrum sorted(const MatrixX& X, const MatrixX& J) {
    const VectorX norms = X.colwise().stableNorm();
    std::vector<Eigen::Index> order(at(norms.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::ranges::stable_sort(order, [&](Eigen::Index a, Eigen::Index b) { return norms(a) > norms(b); });
    Spectrum out{VectorX(norms.size()), MatrixX(X.rows(), X.cols()), MatrixX(J.rows(), J.cols())};
    for (Eigen::Index k = 0; k < norms.size(); ++k) {
        const Eigen::Index from = order[at(k)];
        out.sigma(k) = norms(from);
        out.W.col(k) = X.col(from) / norms(from);
        out.J.col(k) = J.col(from);
    }
    return out;
}

/// Identity matrix with `block` in the top left corner.
MatrixX bordered(const MatrixX& block, Eigen::Index rows, Eigen::Index columns) {
    MatrixX out = MatrixX::Identity(rows, columns);
    out.topLeftCorner(block.rows(), block.cols()) = block;
    return out;
}

/// Factors a matrix with at least as many rows as columns and no entry larger than 2:
///
///   A P = Q1 [R; 0],   Rᵀ = Q2 [L; 0] with L upper,   Lᵀ J = W Σ
///   A = Q1 [W 0; 0 I] Σ (P Q2 [J 0; 0 I])ᵀ
///
/// Pivoting makes R, and the second decomposition Lᵀ, so nearly diagonal that few rotations are left.
Factors factors_of(const MatrixX& tall, Eigen::Index left_columns) {
    const Eigen::Index columns = tall.cols();
    const Eigen::ColPivHouseholderQR<MatrixX> qr(tall);
    const MatrixX& QR = qr.matrixQR();
    Eigen::Index rank = 0;
    while (rank < columns && std::abs(QR(rank, rank)) > kVanished) { ++rank; }
    Factors out{VectorX::Zero(columns), {}, {}};
    if (rank == 0) {
        out.left.setIdentity(tall.rows(), left_columns);
        out.right.setIdentity(columns, columns);
        return out;
    }

    const MatrixX R = QR.topRows(rank).triangularView<Eigen::Upper>();
    const Eigen::HouseholderQR<MatrixX> second(R.transpose());
    MatrixX X = MatrixX(second.matrixQR().topRows(rank).triangularView<Eigen::Upper>()).transpose();
    MatrixX J = MatrixX::Identity(rank, rank);
    make_columns_orthogonal(X, J);

    const Spectrum spectrum = sorted(X, J);
    out.sigma.head(rank) = spectrum.sigma;
    out.left = bordered(spectrum.W, tall.rows(), left_columns);
    multiply_by_q(qr.householderQ(), out.left);
    out.right = bordered(spectrum.J, columns, columns);
    multiply_by_q(second.householderQ(), out.right);
    out.right.applyOnTheLeft(qr.colsPermutation());
    return out;
}

double departure_from_orthogonal(const MatrixX& Q) {
    MatrixX product = MatrixX::Identity(Q.cols(), Q.cols());
    product.selfadjointView<Eigen::Lower>().rankUpdate(Q.transpose(), -1.0);
    return MatrixX(product.selfadjointView<Eigen::Lower>()).norm();
}

Svd not_finite(Eigen::Index rows, Eigen::Index columns) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const Eigen::Index k = std::min(rows, columns);
    return {
        VectorX::Constant(k, nan),
        MatrixX::Identity(rows, k),
        MatrixX::Identity(columns, columns),
        infinite,
        0.0,
        infinite,
        infinite,
        false};
}

}  // namespace

Eigen::Index Svd::rank(double threshold) const {
    return std::ranges::count_if(sigma, [&](double s) { return s > threshold; });
}

void check_svd(const MatrixX& matrix, Svd& svd) {
    const Eigen::Index k = svd.sigma.size();
    const auto size = static_cast<double>(std::max(matrix.rows(), matrix.cols()));
    MatrixX rest = matrix;
    rest.noalias() -= (svd.U * svd.sigma.asDiagonal()) * svd.V.leftCols(k).transpose();
    svd.misfit = rest.norm();
    const double delta_U = departure_from_orthogonal(svd.U);
    const double delta_V = departure_from_orthogonal(svd.V);
    svd.orthogonality = std::max(delta_U, delta_V);
    const double norm = matrix.norm();
    svd.norm_defect = norm > 0.0 ? std::abs(svd.sigma.norm() / norm - 1.0) * 2.0 : 0.0;

    // a sum of k products has k roundings of Σ |u σ v|, whose norm is at most Σ σ; likewise for UᵀU
    const double of_products = size * kUnitRoundoff * svd.sigma.sum();
    const double factors = delta_U + delta_V + delta_U * delta_V + 2.0 * size * kUnitRoundoff;
    svd.error = svd.misfit + of_products + svd.sigma(0) * factors;
    const double rounding = kRoundings * size * kUnitRoundoff;
    svd.sound = svd.misfit <= rounding * norm && svd.orthogonality <= rounding * std::sqrt(size) &&
                svd.norm_defect <= 2.0 * rounding;
}

Svd svd_of(const MatrixX& matrix) {
    const Eigen::Index rows = matrix.rows();
    const Eigen::Index columns = matrix.cols();
    if (matrix.size() == 0) { return {{}, MatrixX(rows, 0), MatrixX::Identity(columns, columns)}; }
    if (!matrix.allFinite()) { return not_finite(rows, columns); }
    const double largest = matrix.cwiseAbs().maxCoeff();
    const double scale = largest > 0.0 ? power_of_two_near(largest) : 1.0;
    Svd svd;
    if (rows >= columns) {
        Factors f = factors_of(matrix / scale, columns);
        svd.U = std::move(f.left);
        svd.V = std::move(f.right);
        svd.sigma = std::move(f.sigma);
    } else {
        Factors f = factors_of(matrix.transpose() / scale, columns);
        svd.V = std::move(f.left);
        svd.U = std::move(f.right);
        svd.sigma = std::move(f.sigma);
    }
    svd.sigma *= scale;
    check_svd(matrix, svd);
    return svd;
}

}  // namespace jw
