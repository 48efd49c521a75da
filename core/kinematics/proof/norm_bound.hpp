#pragma once

#include <cmath>

#include "core/numerics/linear.hpp"

namespace jw {

/// Upper bound of the largest singular value of a block of at most 4 x 4 numbers, at most 2 % above it. The
/// sum of squares would be 2 for a rotation of Euler parameters: a bound that is passed on along a chain of
/// bodies would double from body to body.
double norm_bound(const auto& block) {
    const double size = block.norm();
    if (!(size > 0.0) || !std::isfinite(size)) { return size; }
    Mat4 scaled = Mat4::Zero();
    scaled.topLeftCorner(block.rows(), block.cols()) = block / size;
    // ‖B‖⁶⁴ ≤ ‖(BᵀB)³²‖, and at most twice as large
    Mat4 power = scaled.transpose() * scaled;
    constexpr int squarings = 5;
    for (int k = 0; k < squarings; ++k) { power = (power * power).eval(); }
    double bound = power.norm();
    for (int k = 0; k <= squarings; ++k) { bound = std::sqrt(bound); }
    constexpr double rounding = 1e-12;
    return (1.0 + rounding) * size * bound;
}

}  // namespace jw
