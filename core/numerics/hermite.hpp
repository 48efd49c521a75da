#pragma once

#include <array>
#include <span>

#include "core/numerics/linear.hpp"

namespace jw {

/// Hermite polynomial of many numbers at once, through their values and derivatives at some times.
class HermitePolynomial {
public:
    static constexpr std::size_t kMostNodes = 4;

    struct Node {
        double t = 0.0;
        Eigen::ArrayX3d known;  ///< columns: values, rates and half the second derivatives
    };
    /// Data that the polynomial interpolates at every node.
    enum class Meets { values_and_rates = 2, second_derivatives_too = 3 };

    /// @param nodes at different times, at most kMostNodes
    void fit(std::span<const Node> nodes, Meets meets);
    /// Evaluates value and rate at t.
    void evaluate(double t);
    Eigen::ArrayX2d::ConstColXpr value() const { return value_and_rate_.col(0); }
    Eigen::ArrayX2d::ConstColXpr rate() const { return value_and_rate_.col(1); }

private:
    // Newton's form; every node is repeated for each known derivative
    std::array<double, 3 * kMostNodes> x_{};
    std::size_t size_ = 0;
    Eigen::ArrayXXd coefficients_;
    Eigen::ArrayX2d value_and_rate_;
};

}  // namespace jw
