#pragma once

#include <array>
#include <span>

#include "core/linear.hpp"

namespace jw {

/// A polynomial for many numbers at once through what is known of them at some times.
class HermitePolynomial {
public:
    static constexpr std::size_t kMostNodes = 4;

    struct Node {
        double t = 0.0;
        Eigen::ArrayX3d known;  ///< values, rates and half the second derivatives side by side
    };
    /// What it meets at every node.
    enum class Meets { values_and_rates = 2, second_derivatives_too = 3 };

    /// @param nodes at different times, at most kMostNodes
    void fit(std::span<const Node> nodes, Meets meets);
    /// Sets value and rate.
    void evaluate(double t);
    Eigen::ArrayX2d::ConstColXpr value() const { return value_and_rate_.col(0); }
    Eigen::ArrayX2d::ConstColXpr rate() const { return value_and_rate_.col(1); }

private:
    // Newton's form; every node stands as often as something is known there
    std::array<double, 3 * kMostNodes> x_{};
    Eigen::Index size_ = 0;
    Eigen::ArrayXXd coefficients_;
    Eigen::ArrayXXd differences_;
    Eigen::ArrayX2d value_and_rate_;
};

}  // namespace jw
