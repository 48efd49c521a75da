#include "core/numerics/hermite.hpp"

namespace jw {

namespace {

/// Numbers that are computed together, in registers.
constexpr int kTogether = 4;

/// Calls `f` with blocks of rows: their first one, and their number as a constant.
template <class F>
void for_each_block_of_rows(Eigen::Index rows, F&& f) {
    Eigen::Index row = 0;
    for (; row + kTogether <= rows; row += kTogether) { f(row, std::integral_constant<int, kTogether>{}); }
    for (; row < rows; ++row) { f(row, std::integral_constant<int, 1>{}); }
}

}  // namespace

void HermitePolynomial::fit(std::span<const Node> nodes, Meets meets) {
    const auto each = static_cast<std::size_t>(meets);
    size_ = each * nodes.size();
    const Eigen::Index rows = nodes.front().known.rows();
    // largest size, so that no later fit allocates
    coefficients_.resize(rows, 3 * kMostNodes);
    value_and_rate_.resize(rows, 2);
    for (std::size_t k = 0; k < size_; ++k) { x_[k] = nodes[k / each].t; }
    // 1 / width of every divided difference; 0 within a node
    std::array<std::array<double, 3 * kMostNodes>, 3 * kMostNodes> per_width;
    for (std::size_t order = 1; order < size_; ++order) {
        for (std::size_t k = order; k < size_; ++k) {
            const double width = x_[k] - x_[k - order];
            per_width[order][k] = width == 0.0 ? 0.0 : 1.0 / width;
        }
    }
    for_each_block_of_rows(rows, [&](Eigen::Index row, auto count) {
        const auto known = [&](std::size_t k, std::size_t derivative) {
            return nodes[k / each]
                .known.col(static_cast<Eigen::Index>(derivative))
                .template segment<count>(row);
        };
        const auto coefficient = [&](std::size_t k) {
            return coefficients_.col(static_cast<Eigen::Index>(k)).template segment<count>(row);
        };
        std::array<Eigen::Array<double, count, 1>, 3 * kMostNodes> difference;
        difference.fill(Eigen::Array<double, count, 1>::Zero());
        for (std::size_t k = 0; k < size_; ++k) { difference[k] = known(k, 0); }
        coefficient(0) = difference[0];
        for (std::size_t order = 1; order < size_; ++order) {
            for (std::size_t k = size_ - 1; k >= order; --k) {
                if (per_width[order][k] == 0.0) {
                    difference[k] = known(k, order);
                } else {
                    difference[k] = (difference[k] - difference[k - 1]) * per_width[order][k];
                }
            }
            coefficient(order) = difference[order];
        }
    });
}

void HermitePolynomial::evaluate(double t) {
    for_each_block_of_rows(coefficients_.rows(), [&](Eigen::Index row, auto count) {
        const auto coefficient = [&](std::size_t k) {
            return coefficients_.col(static_cast<Eigen::Index>(k)).template segment<count>(row);
        };
        std::size_t k = size_ - 1;
        Eigen::Array<double, count, 1> value = coefficient(k);
        Eigen::Array<double, count, 1> rate = Eigen::Array<double, count, 1>::Zero();
        while (k-- > 0) {
            const double way = t - x_[k];
            rate = rate * way + value;
            value = value * way + coefficient(k);
        }
        value_and_rate_.col(0).template segment<count>(row) = value;
        value_and_rate_.col(1).template segment<count>(row) = rate;
    });
}

}  // namespace jw
