#include "core/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace jw {

template <class C>
Scaling scaling_of(const System& system, bool normalisation_rows) {
    Scaling scaling;
    const int rows = system.rows(C::kNormalised && normalisation_rows);
    scaling.row.resize(rows);
    for (int row = 0; row < rows; ++row) { scaling.row(row) = system.row_unit(row); }
    scaling.column = VectorX::Ones(system.columns(C::kAngular));
    for (const int body : system.moving_bodies()) {
        scaling.column.segment<3>(system.body_column(body, C::kAngular)).setConstant(system.length_unit());
    }
    return scaling;
}

template Scaling scaling_of<TrueEulerParameters>(const System&, bool);
template Scaling scaling_of<ModifiedEulerParameters>(const System&, bool);
template Scaling scaling_of<OmegaLocal>(const System&, bool);
template Scaling scaling_of<OmegaGlobal>(const System&, bool);

LeastSquares::LeastSquares(Scaling scaling)
    : scaling_(std::move(scaling)),
      transposed_(scaling_.column.size(), scaling_.row.size()),
      qr_(scaling_.column.size(), scaling_.row.size()),
      c_(scaling_.row.size()),
      y_(scaling_.column.size()),
      W_(scaling_.row.size(), scaling_.row.size()),
      normal_(scaling_.row.size(), scaling_.row.size()),
      inconsistency_(scaling_.row.size()) {}

void LeastSquares::compute(const MatrixX& jacobian) {
    for (Eigen::Index row = 0; row < jacobian.rows(); ++row) {
        transposed_.col(row) =
            jacobian.row(row).transpose().cwiseProduct(scaling_.column) / scaling_.row(row);
    }
    if (transposed_.size() > 0) { qr_.compute(transposed_); }
}

double LeastSquares::relative_pivot(int k) const {
    const MatrixX& R = qr_.matrixQR();
    const double largest = std::abs(R(0, 0));
    return largest > 0.0 ? std::abs(R(k, k)) / largest : 0.0;
}

int LeastSquares::rank(double relative_threshold) const {
    if (transposed_.size() == 0) { return 0; }
    const int pivots = static_cast<int>(std::min(transposed_.rows(), transposed_.cols()));
    int rank = 0;
    while (rank < pivots && relative_pivot(rank) > relative_threshold) { ++rank; }
    return rank;
}

void LeastSquares::solve_lower(int rank, VectorX& c) const {
    qr_.matrixQR()
        .topLeftCorner(rank, rank)
        .triangularView<Eigen::Upper>()
        .transpose()
        .solveInPlace(c.head(rank));
}

void LeastSquares::solve(const VectorX& b, int rank, VectorX& x) {
    x.setZero(scaling_.column.size());
    if (rank == 0) { return; }
    const auto& permutation = qr_.colsPermutation().indices();
    const Eigen::Index rows = scaling_.row.size();
    const Eigen::Index redundant = rows - rank;
    for (Eigen::Index k = 0; k < rows; ++k) { c_(k) = b(permutation(k)) / scaling_.row(permutation(k)); }

    if (redundant > 0) {
        // [I; W] z = [c1; c2] in least squares: z = c1 + Wᵀ (I + W Wᵀ)⁻¹ (c2 - W c1)
        auto W = W_.topLeftCorner(redundant, rank);
        W = qr_.matrixQR().topRightCorner(qr_.matrixQR().rows(), redundant).topRows(rank).transpose();
        qr_.matrixQR()
            .topLeftCorner(rank, rank)
            .triangularView<Eigen::Upper>()
            .transpose()
            .solveInPlace<Eigen::OnTheRight>(W);
        auto normal = normal_.topLeftCorner(redundant, redundant);
        normal.setIdentity();
        normal.noalias() += W.lazyProduct(W.transpose());
        auto e = inconsistency_.head(redundant);
        e = c_.tail(redundant);
        e.noalias() -= W.lazyProduct(c_.head(rank));
        Eigen::Ref<MatrixX> normal_ref = normal;
        Eigen::LLT<Eigen::Ref<MatrixX>>(normal_ref).solveInPlace(e);
        c_.head(rank).noalias() += W.transpose().lazyProduct(e);
    }

    // x = Q1 R11⁻ᵀ z, the reflections applied last to first
    solve_lower(rank, c_);
    y_.setZero();
    y_.head(rank) = c_.head(rank);
    for (Eigen::Index k = rank - 1; k >= 0; --k) { reflect(k); }
    x = y_.cwiseProduct(scaling_.column);
}

void LeastSquares::reflect(Eigen::Index k) {
    const MatrixX& QR = qr_.matrixQR();
    const auto tail = QR.col(k).tail(QR.rows() - k - 1);
    auto y_tail = y_.tail(QR.rows() - k - 1);
    const double projection = qr_.hCoeffs()(k) * (y_(k) + tail.dot(y_tail));
    y_(k) -= projection;
    y_tail -= projection * tail;
}

void LeastSquares::solve_transposed(const VectorX& force, int rank, VectorX& lambda) {
    lambda.setZero(scaling_.row.size());
    if (rank == 0) { return; }
    y_ = force.cwiseProduct(scaling_.column);
    for (Eigen::Index k = 0; k < rank; ++k) { reflect(k); }
    auto z = y_.head(rank);
    qr_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(z);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const Eigen::Index row = qr_.colsPermutation().indices()(k);
        lambda(row) = z(k) / scaling_.row(row);
    }
}

void LeastSquares::keep_free_part(int rank, VectorX& x) {
    // Q1ᵀ x is what the independent rows see: the reflections applied first to last, and back without it
    y_ = x.cwiseQuotient(scaling_.column);
    for (Eigen::Index k = 0; k < rank; ++k) { reflect(k); }
    y_.head(rank).setZero();
    for (Eigen::Index k = rank - 1; k >= 0; --k) { reflect(k); }
    x = y_.cwiseProduct(scaling_.column);
}

}  // namespace jw
