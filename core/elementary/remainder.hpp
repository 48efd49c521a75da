#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/elementary/pair.hpp"

/// Angles without their quarter turns: the first step of sine, cosine and tangent.
namespace jw::elementary {

// 2/π, and π/2 in three parts, the first two of 33 bits (Cody and Waite): products with up to 20 bits of
// quarter turns are exact
constexpr double kQuartersPerRadian = 6.36619772367581382433e-01;
constexpr double kQuarter = 1.57079632673412561417e+00;
constexpr double kQuarterNext = 6.07710050630396597660e-11;
constexpr double kQuarterLast = 2.02226624879595063154e-21;
/// 2^20 quarter turns [rad]
constexpr double kFar = 1.6e6;
/// Remainder below which three parts of π/2 are not enough: they omit 2^-122 of it, up to a million times.
constexpr double kNear = 0x1p-28;

/// Angle as quarter turns and a remainder that exceeds π/4 only slightly, if at all.
struct Remainder {
    Pair angle;        ///< [rad], with a relative error below 2^-70
    int quarters = 0;  ///< modulo 4
};

/// Remainder of any finite angle of at least π/4 [rad].
Remainder exact_remainder(double angle);

/// @param angle finite [rad]
inline Remainder remainder_of(double angle) {
    const double size = std::abs(angle);
    if (size <= 0.25 * kPi.high) { return {{angle, 0.0}, 0}; }
    if (!(size < kFar)) { return exact_remainder(angle); }
    const double rounded = angle * kQuartersPerRadian + kRounds;
    const double quarters = rounded - kRounds;
    const double without_first = angle - quarters * kQuarter;
    const Pair without_next = sum(without_first, -(quarters * kQuarterNext));
    const Pair left = sum_of_ordered(without_next.high, without_next.low - quarters * kQuarterLast);
    if (std::abs(left.high) < kNear) { return exact_remainder(angle); }
    return {left, static_cast<int>(std::bit_cast<std::uint64_t>(rounded) & 3U)};
}

}  // namespace jw::elementary
