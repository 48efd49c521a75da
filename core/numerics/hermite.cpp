#include "core/numerics/hermite.hpp"

namespace jw {

void HermitePolynomial::fit(std::span<const Node> nodes, Meets meets) {
    const auto each = static_cast<std::size_t>(meets);
    const auto node_of = [&](Eigen::Index k) -> const Node& { return nodes[at(k) / each]; };
    size_ = static_cast<Eigen::Index>(each * nodes.size());
    const Eigen::Index rows = nodes.front().known.rows();
    // largest size, so that no later fit allocates
    coefficients_.resize(rows, 3 * kMostNodes);
    differences_.resize(rows, 3 * kMostNodes);
    value_and_rate_.resize(rows, 2);
    for (Eigen::Index k = 0; k < size_; ++k) {
        x_[at(k)] = node_of(k).t;
        differences_.col(k) = node_of(k).known.col(0);
    }
    coefficients_.col(0) = differences_.col(0);
    for (Eigen::Index order = 1; order < size_; ++order) {
        for (Eigen::Index k = size_ - 1; k >= order; --k) {
            const double width = x_[at(k)] - x_[at(k - order)];
            if (width == 0.0) {
                differences_.col(k) = node_of(k).known.col(order);
            } else {
                differences_.col(k) = (differences_.col(k) - differences_.col(k - 1)) * (1.0 / width);
            }
        }
        coefficients_.col(order) = differences_.col(order);
    }
}

void HermitePolynomial::evaluate(double t) {
    auto value = value_and_rate_.col(0);
    auto rate = value_and_rate_.col(1);
    Eigen::Index k = size_ - 1;
    value = coefficients_.col(k);
    rate.setZero();
    while (k-- > 0) {
        const double way = t - x_[at(k)];
        rate = rate * way + value;
        value = value * way + coefficients_.col(k);
    }
}

}  // namespace jw
