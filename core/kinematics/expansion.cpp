#include "core/kinematics/expansion.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// Roundings that each order adds to a coefficient: a product of four factors and the sum of a row.
constexpr double kRoundingOfOrder = 64.0 * 0x1p-53;

}  // namespace

Expansion::Expansion(const System& system, const State& state, const Motion& velocity)
    : step_(system), tolerance_(kRankThreshold) {
    const PathEnd pose{0.0, &state, &velocity};
    step_.set(pose, pose);
    for (const double phi : step_.from().phi) { tolerance_ = std::max(tolerance_, kErrorFactor * phi); }
    find_linked();
    if (columns_ > kMostProvedColumns) { return; }
    order_equations();
    choose_independent();
}

/// Finds the bodies that the velocity moves and those that equations link to them: only these take part.
void Expansion::find_linked() {
    const auto& all = step_.table().all();
    const auto speed = [&](const Coordinates& c) {
        if (c.theta >= 0) { return std::abs(step_.from().theta_dot[at(c.theta)]); }
        return c.size == 3 ? step_.from().r_dot[at(c.body)].norm() / c.scale
                           : step_.from().p_dot[at(c.body)].norm();
    };
    double largest = 0.0;
    for (const Coordinates& c : all) { largest = std::max(largest, speed(c)); }
    std::vector<bool> is_moved;
    for (const Coordinates& c : all) { is_moved.push_back(speed(c) > kLeastSpeed * largest); }
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t e = 0; e < step_.equations().size(); ++e) {
            const std::array<int, kBlocks>& blocks = step_.blocks(static_cast<int>(e));
            const auto linked = [&](int k) { return k >= 0 && is_moved[at(k)]; };
            if (std::ranges::none_of(blocks, linked)) { continue; }
            for (const int k : blocks) {
                grows = grows || (k >= 0 && !linked(k));
                if (k >= 0) { is_moved[at(k)] = true; }
            }
        }
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        first_column_.push_back(is_moved[k] ? columns_ : -1);
        columns_ += is_moved[k] ? all[k].size : 0;
    }
}

bool Expansion::is_linked(int equation) const {
    return std::ranges::any_of(
        step_.blocks(equation), [&](int k) { return k >= 0 && first_column_[at(k)] >= 0; });
}

/// Orders the equations as they were added, after the lengths of p, which are always independent.
void Expansion::order_equations() {
    for (const bool lengths : {true, false}) {
        for (std::size_t e = 0; e < step_.equations().size(); ++e) {
            const ProvedEquation& equation = step_.equations()[e];
            const bool is_length = std::holds_alternative<UnitLength>(equation.primitive);
            if (is_length != lengths || equation.rows == 0 || !is_linked(static_cast<int>(e))) { continue; }
            rows_.push_back({static_cast<int>(e), rows_count_, {}});
            rows_count_ += equation.rows;
        }
    }
}

MatrixX Expansion::jacobian_of(int equation) {
    MatrixX J = MatrixX::Zero(step_.equations()[at(equation)].rows, columns_);
    for_each_block(
        step_.blocks(equation), step_.jacobian_at(step_.from(), equation),
        [&](int k, const MatrixX& block) { J.middleCols(first_column_[at(k)], block.cols()) += block; });
    return J;
}

/// Chooses independent rows, whose J is L Qᵀ. The rows of an equation are rotated, so that the misfits do not
/// depend on the directions in which the equation is written.
void Expansion::choose_independent() {
    J_ = MatrixX::Zero(rows_count_, columns_);
    Q_ = MatrixX::Zero(columns_, columns_);
    L_ = MatrixX::Zero(columns_, columns_);
    for (Rows& rows : rows_) {
        const MatrixX J = jacobian_of(rows.equation);
        const auto own = Q_.leftCols(static_cast<Eigen::Index>(independent_.size()));
        const Eigen::ColPivHouseholderQR<MatrixX> qr(J - (J * own) * own.transpose());
        rows.turn = MatrixX::Identity(J.rows(), J.rows());
        multiply_by_q(qr.householderQ(), rows.turn);
        J_.middleRows(rows.first, J.rows()) = rows.turn.transpose() * J;
        for (Eigen::Index k = 0; k < J.rows(); ++k) { add_row(rows.first + static_cast<int>(k)); }
    }
    const auto rank = static_cast<Eigen::Index>(independent_.size());
    Q_.conservativeResize(Eigen::NoChange, rank);
    L_.conservativeResize(rank, rank);
}

/// Adds a row. It is independent if enough of it is left after its projection on earlier rows is removed.
/// This is done twice: the first removal leaves rounding of the size of the projection.
void Expansion::add_row(int row) {
    const auto r = static_cast<Eigen::Index>(independent_.size());
    VectorX rest = J_.row(row).transpose();
    VectorX within = VectorX::Zero(r);
    for (int k = 0; k < 2; ++k) {
        const VectorX share = Q_.leftCols(r).transpose() * rest;
        within += share;
        rest -= Q_.leftCols(r) * share;
    }
    const double left = rest.norm();
    is_independent_.push_back(r < columns_ && left > tolerance_);
    if (!is_independent_.back()) { return; }
    least_pivot_ = std::min(least_pivot_, left);
    Q_.col(r) = rest / left;
    L_.row(r).head(r) = within.transpose();
    L_(r, r) = left;
    independent_.push_back(row);
}

VectorX Expansion::velocity() const {
    VectorX x = VectorX::Zero(columns_);
    for (std::size_t k = 0; k < first_column_.size(); ++k) {
        const Coordinates& c = step_.table().all()[k];
        const int first = first_column_[k];
        if (first < 0) { continue; }
        if (c.theta >= 0) {
            x(first) = step_.from().theta_dot[at(c.theta)];
        } else if (c.size == 3) {
            x.segment<3>(first) = step_.from().r_dot[at(c.body)] / c.scale;
        } else {
            x.segment<4>(first) = step_.from().p_dot[at(c.body)];
        }
    }
    return x;
}

BodyKinematics<PowerSeries> Expansion::body(int index) const {
    BodyKinematics<PowerSeries> series;
    series.r.col(0) = step_.from().state.r[at(index)];
    series.p.col(0) = step_.from().state.p[at(index)];
    const int k = step_.table().of_body(index);
    if (k < 0 || first_column_[at(k)] < 0) { return series; }
    for (int order = 1; order < kOrders; ++order) {
        const VectorX& x = x_[at(order)];
        series.r.col(order) = step_.length() * x.segment<3>(first_column_[at(k)]);
        series.p.col(order) = x.segment<4>(first_column_[at(k + 1)]);
    }
    return series;
}

/// Coefficient `order` of all rows along the path so far.
void Expansion::evaluate(int order) {
    for (const Rows& rows : rows_) {
        const ProvedEquation& equation = step_.equations()[at(rows.equation)];
        SeriesOfTheta theta;
        theta.value(0) = step_.from().thetas[at(rows.equation)].value;
        if (equation.theta >= 0) {
            const int column = first_column_[at(step_.table().of_theta(equation.theta))];
            for (int k = 1; k < kOrders; ++k) { theta.value(k) = x_[at(k)](column); }
        }
        VectorX value(equation.rows);
        visit_equation<Content::motion>(
            equation, body(equation.body_i), body(equation.body_j), theta, [&](const auto& jet) {
                const auto w = jet.coefficient(order);
                Eigen::Index row = 0;
                for (int k = 0; k < std::decay_t<decltype(jet)>::kDim; ++k) {
                    if (equation.has_row(k)) { value(row++) = w(k) / equation.unit; }
                }
                size_.segment(rows.first, equation.rows).setConstant(jet.size(order) / equation.unit);
            });
        value_.segment(rows.first, equation.rows) = rows.turn.transpose() * value;
    }
}

/// Coefficient of the path that satisfies the independent rows.
VectorX Expansion::solve(int order) {
    evaluate(order);
    VectorX y(static_cast<Eigen::Index>(independent_.size()));
    for (Eigen::Index k = 0; k < y.size(); ++k) {
        y(k) = (-value_(independent_[at(k)]) - L_.row(k).head(k).dot(y.head(k))) / L_(k, k);
    }
    return Q_ * y;
}

/// The equation with the largest misfit that errors do not explain.
Missed Expansion::worst(int order, const VectorX& own) const {
    Missed missed{order, 0.0, 0};
    const double spread = kRoundingOfOrder * order * size_.maxCoeff() / least_pivot_;
    for (const Rows& rows : rows_) {
        double square = 0.0;
        double terms = 0.0;
        for (int row = rows.first; row < rows.first + static_cast<int>(rows.turn.rows()); ++row) {
            if (is_independent_[at(row)]) { continue; }
            const double value = value_(row) + J_.row(row).dot(own);
            square += value * value;
            terms += size_(row) + J_.row(row).cwiseAbs().dot(own.cwiseAbs());
        }
        const double value = std::sqrt(square);
        if (value > tolerance_ * terms + spread && value > missed.value) {
            missed = {order, value, rows.equation};
        }
    }
    return missed;
}

Misfits Expansion::expand(const VectorX& first) {
    x_.fill(VectorX::Zero(columns_));
    value_.setZero(rows_count_);
    size_.setZero(rows_count_);
    Misfits misfits;
    misfits[0] = worst(0, solve(0));
    x_[1] = first;
    for (int order = 2; order < kOrders; ++order) {
        x_[at(order)] = solve(order);
        misfits[at(order)] = worst(order, x_[at(order)]);
    }
    return misfits;
}

}  // namespace jw
