#include "core/poses/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"

namespace jw {

namespace {

// first threshold of Newton's method: pivots below it count as rounding
constexpr double kFirstThreshold = 1e-9;
// contradiction of redundant rows (scaled) that is rounding
constexpr double kRounding = 1e-14;
// conjugate gradients: far below the tolerance of positions, and a reserve of steps (tens are enough)
constexpr double kSpreadTolerance = 1e-12;
constexpr int kMostSpreadSteps = 300;

}  // namespace

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

LeastSquares::LeastSquares(Scaling scaling) : scaling_(std::move(scaling)) {
    const Eigen::Index rows = scaling_.row.size();
    const Eigen::Index columns = scaling_.column.size();
    if (columns > kMostDenseColumns) {
        sparse_ = std::make_unique<SparseQr>();
    } else {
        transposed_.resize(columns, rows);
        qr_ = Eigen::ColPivHouseholderQR<MatrixX>(columns, rows);
        W_.resize(rows, rows);
        normal_.resize(rows, rows);
    }
    c_.resize(rows);
    y_.resize(columns);
    inconsistency_.resize(rows);
}

void LeastSquares::compute(const SparseRows& jacobian) {
    if (sparse_) {
        rows_ = jacobian;
        factor_sparsely(kFirstThreshold);
        return;
    }
    transposed_.setZero();
    for (std::size_t r = 0; r < jacobian.rows.size(); ++r) {
        const auto row = static_cast<Eigen::Index>(r);
        jacobian.for_each_entry(jacobian.rows[r], [&](int column, double value) {
            transposed_(column, row) = value * scaling_.column(column) / scaling_.row(row);
        });
    }
    if (transposed_.size() > 0) { qr_.compute(transposed_); }
}

double LeastSquares::relative_pivot(int k) const {
    if (sparse_) { return pivots_[at(k)]; }
    const MatrixX& R = qr_.matrixQR();
    const double largest = std::abs(R(0, 0));
    return largest > 0.0 ? std::abs(R(k, k)) / largest : 0.0;
}

int LeastSquares::rank(double relative_threshold) const {
    if (sparse_) {
        // another threshold changes the choice of rows only if other pivots count
        const auto above = [&](double threshold) {
            return std::ranges::count_if(pivots_, [&](double pivot) { return pivot > threshold; });
        };
        if (above(relative_threshold) != above(sparse_->threshold())) { factor_sparsely(relative_threshold); }
        return sparse_->rank();
    }
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
    if (sparse_) {
        reach_rank(rank);
        solve_sparsely(b, x);
        return;
    }
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
    if (sparse_) {
        reach_rank(rank);
        sparse_->multiply_by_q_transposed(y_);
        for (const int row : sparse_->counted()) { lambda(row) = y_(sparse_->slot_of(row)); }
        sparse_->solve_upper(lambda);
        lambda = lambda.cwiseQuotient(scaling_.row);
        return;
    }
    for (Eigen::Index k = 0; k < rank; ++k) { reflect(k); }
    auto z = y_.head(rank);
    qr_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(z);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const Eigen::Index row = qr_.colsPermutation().indices()(k);
        lambda(row) = z(k) / scaling_.row(row);
    }
}

void LeastSquares::keep_free_part(int rank, VectorX& x) {
    // Q1ᵀ x is the part that the independent rows constrain: apply the reflections first to last, and back
    // without that part
    y_ = x.cwiseQuotient(scaling_.column);
    if (sparse_) {
        reach_rank(rank);
        sparse_->multiply_by_q_transposed(y_);
        for (const int row : sparse_->counted()) { y_(sparse_->slot_of(row)) = 0.0; }
        sparse_->multiply_by_q(y_);
        x = y_.cwiseProduct(scaling_.column);
        return;
    }
    for (Eigen::Index k = 0; k < rank; ++k) { reflect(k); }
    y_.head(rank).setZero();
    for (Eigen::Index k = rank - 1; k >= 0; --k) { reflect(k); }
    x = y_.cwiseProduct(scaling_.column);
}

void LeastSquares::factor_sparsely(double threshold) const {
    sparse_->compute(rows_, scaling_.row, scaling_.column, threshold);
    pivots_ = sparse_->pivots();
    std::ranges::sort(pivots_, std::greater<>());
}

/// Factors again if a caller counts fewer or more rows than the present factors.
void LeastSquares::reach_rank(int rank) const {
    if (sparse_->rank() == rank || rank > static_cast<int>(pivots_.size())) { return; }
    factor_sparsely(rank < static_cast<int>(pivots_.size()) ? pivots_[at(rank)] : 0.0);
}

void LeastSquares::solve_sparsely(const VectorX& b, VectorX& x) {
    VectorX c = b.cwiseQuotient(scaling_.row);
    spread_inconsistency(c);
    sparse_->solve_lower(c);
    y_.setZero();
    for (const int row : sparse_->counted()) { y_(sparse_->slot_of(row)) = c(row); }
    sparse_->multiply_by_q(y_);
    x = y_.cwiseProduct(scaling_.column);
}

/// Distributes the contradiction of redundant rows. As in the dense case, [I; W] z = [c1; c2] in least
/// squares, z = c1 + Wᵀ (I + W Wᵀ)⁻¹ (c2 - W c1), where the inverse is applied by conjugate gradients: only
/// products with W are known. Rows that do not contradict the others leave c1 unchanged.
void LeastSquares::spread_inconsistency(VectorX& c) {
    const std::vector<int>& repeating = sparse_->repeating();
    if (repeating.empty()) { return; }
    const auto count = static_cast<Eigen::Index>(repeating.size());
    const auto repeating_part = [&](const VectorX& all) {
        VectorX part(count);
        for (Eigen::Index k = 0; k < count; ++k) { part(k) = all(repeating[at(k)]); }
        return part;
    };
    // Wᵀ u, zero for redundant rows
    const auto w_transposed = [&](const VectorX& u) {
        VectorX v = VectorX::Zero(c.size());
        for (Eigen::Index k = 0; k < count; ++k) { v(repeating[at(k)]) = -u(k); }
        sparse_->solve_upper(v);
        for (const int row : repeating) { v(row) = 0.0; }
        return v;
    };
    VectorX eliminated = c;
    sparse_->solve_lower(eliminated);
    VectorX rest = repeating_part(eliminated);
    if (rest.cwiseAbs().maxCoeff() <= kRounding) { return; }

    const double start = rest.norm();
    VectorX u = VectorX::Zero(count);
    VectorX direction = rest;
    double square = rest.squaredNorm();
    for (int k = 0; k < kMostSpreadSteps && std::sqrt(square) > kSpreadTolerance * start; ++k) {
        VectorX image = w_transposed(direction);
        sparse_->solve_lower(image);
        const VectorX product = direction - repeating_part(image);
        const double step = square / direction.dot(product);
        u += step * direction;
        rest -= step * product;
        const double next = rest.squaredNorm();
        direction = rest + next / square * direction;
        square = next;
    }
    c += w_transposed(u);
}

}  // namespace jw
