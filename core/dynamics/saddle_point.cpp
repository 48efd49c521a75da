#include "core/dynamics/saddle_point.hpp"

#include <algorithm>
#include <cmath>

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
    mass_ = columns * mass * columns;
    transposed_.resize(n, rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const int row = kept_[static_cast<std::size_t>(k)];
        transposed_.col(k) = columns * jacobian.row(row).transpose() / scaling_.row(row);
    }
    Q_.setIdentity(n, n);
    smallest_pivot_ = 1.0;
    if (rank > 0) {
        qr_.compute(transposed_);
        Q_ = qr_.householderQ();
        for (Eigen::Index k = 0; k < rank; ++k) {
            const double pivot = qr_.matrixQR()(k, k);
            smallest_pivot_ = std::min(smallest_pivot_, pivot * pivot / transposed_.col(k).squaredNorm());
        }
    }
    const auto Q2 = Q_.rightCols(n - rank);
    if (n > rank) { free_mass_.compute(Q2.transpose() * mass_ * Q2); }
}

void SaddlePoint::solve(const VectorX& f, const VectorX& b, VectorX& x, VectorX& lambda) const {
    const Eigen::Index n = Q_.rows();
    const auto rank = static_cast<Eigen::Index>(kept_.size());
    const auto Q1 = Q_.leftCols(rank);
    const auto Q2 = Q_.rightCols(n - rank);
    const VectorX force = scaling_.column.cwiseProduct(f);
    VectorX scaled = VectorX::Zero(n);
    if (rank > 0) {
        VectorX right(rank);
        for (Eigen::Index k = 0; k < rank; ++k) {
            const int row = kept_[static_cast<std::size_t>(k)];
            right(k) = b(row) / scaling_.row(row);
        }
        const auto R = qr_.matrixQR().topRows(rank).triangularView<Eigen::Upper>();
        scaled = Q1 * R.transpose().solve(right);
    }
    if (n > rank) { scaled += Q2 * free_mass_.solve(Q2.transpose() * (force - mass_ * scaled)); }
    lambda.setZero(scaling_.row.size());
    if (rank > 0) {
        const auto R = qr_.matrixQR().topRows(rank).triangularView<Eigen::Upper>();
        const VectorX multipliers = R.solve(Q1.transpose() * (mass_ * scaled - force));
        for (Eigen::Index k = 0; k < rank; ++k) {
            const int row = kept_[static_cast<std::size_t>(k)];
            lambda(row) = multipliers(k) / scaling_.row(row);
        }
    }
    x = scaling_.column.cwiseProduct(scaled);
}

}  // namespace jw
