#include "core/motion/saddle_point.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"

namespace jw {

SaddlePoint::SaddlePoint(Scaling scaling) : scaling_(std::move(scaling)) {}

bool SaddlePoint::choose_rows(const MatrixX& jacobian, double relative_threshold) {
    const std::vector<int> before = kept_;
    kept_.clear();
    if (jacobian.size() > 0) {
        const MatrixX scaled =
            scaling_.row.cwiseInverse().asDiagonal() * jacobian * scaling_.column.asDiagonal();
        const Eigen::ColPivHouseholderQR<MatrixX> qr(scaled.transpose());
        const MatrixX& R = qr.matrixQR();
        for (Eigen::Index k = 0; k < std::min(R.rows(), R.cols()); ++k) {
            if (!(std::abs(R(k, k)) > relative_threshold * std::abs(R(0, 0)))) { break; }
            kept_.push_back(qr.colsPermutation().indices()(k));
        }
    }
    return !std::ranges::is_permutation(kept_, before);
}

void SaddlePoint::factor(const MatrixX& mass, const MatrixX& jacobian) {
    const auto columns = scaling_.column.asDiagonal();
    const Eigen::Index n = jacobian.cols();
    const auto rank = static_cast<Eigen::Index>(kept_.size());
    MatrixX transposed(n, rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const int row = kept_[static_cast<std::size_t>(k)];
        transposed.col(k) = columns * jacobian.row(row).transpose() / scaling_.row(row);
    }
    whole_ = MatrixX::Zero(n + rank, n + rank);
    whole_.topLeftCorner(n, n) = columns * mass * columns;
    whole_.topRightCorner(n, rank) = transposed;
    whole_.bottomLeftCorner(rank, n) = transposed.transpose();
    lu_.compute(whole_);

    smallest_pivot_ = 1.0;
    if (rank == 0) { return; }
    const Eigen::HouseholderQR<MatrixX> qr(transposed);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const double pivot = qr.matrixQR()(k, k);
        smallest_pivot_ = std::min(smallest_pivot_, pivot * pivot / transposed.col(k).squaredNorm());
    }
}

void SaddlePoint::solve(const VectorX& f, const VectorX& b, VectorX& x, VectorX& lambda) const {
    const Eigen::Index n = f.size();
    const auto rank = static_cast<Eigen::Index>(kept_.size());
    VectorX right(n + rank);
    right.head(n) = scaling_.column.cwiseProduct(f);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const int row = kept_[static_cast<std::size_t>(k)];
        right(n + k) = b(row) / scaling_.row(row);
    }
    VectorX solution = lu_.solve(right);
    // iterative refinement: after the first pass, the residual of every row is small relative to the largest
    // of them; after the second, relative to the row itself; masses may be far apart
    solution += lu_.solve(right - whole_ * solution);
    x = scaling_.column.cwiseProduct(solution.head(n));
    lambda.setZero(scaling_.row.size());
    for (Eigen::Index k = 0; k < rank; ++k) {
        const int row = kept_[static_cast<std::size_t>(k)];
        lambda(row) = -solution(n + k) / scaling_.row(row);
    }
}

}  // namespace jw
