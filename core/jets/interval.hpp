#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary/elementary.hpp"

/// Interval arithmetic: every result contains the results for all numbers of its operands. Ends are moved
/// outwards by more than the rounding error, so that the rounding mode need not be changed.
namespace jw {

struct Interval {
    double low = 0.0;
    double high = 0.0;

    Interval() = default;
    Interval(double number) : low(number), high(number) {}  // NOLINT: a number is an interval
    Interval(double from, double to) : low(from), high(to) {}

    /// All numbers: the result where a function has no value for part of its operand.
    static Interval all() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    bool is_bounded() const { return std::isfinite(low) && std::isfinite(high); }
    bool contains(double number) const { return low <= number && number <= high; }
    /// Largest magnitude.
    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

namespace detail {

/// The interval between two computed ends, each of which may be wrong by some units in the last place.
inline Interval outwards(double low, double high) {
    // the error of elementary functions is at most 0.52 units, that of operations half a unit
    constexpr double ulps = 2.0 * std::numeric_limits<double>::epsilon();
    constexpr double least = std::numeric_limits<double>::min();
    const Interval out(low - ulps * std::abs(low) - least, high + ulps * std::abs(high) + least);
    return out.is_bounded() ? out : Interval::all();
}

/// True if angle + 2πn lies in the interval for some n, or nearly so.
inline bool passes(const Interval& x, double angle) {
    // far above the rounding of the difference below, for angles of any size that a lesson has
    const double slack = 1e-9 * std::max(1.0, x.magnitude());
    constexpr double turn = 2.0 * std::numbers::pi;
    return std::floor((x.high - angle + slack) / turn) >= std::ceil((x.low - angle - slack) / turn);
}

}  // namespace detail

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
    return detail::outwards(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }
inline Interval operator*(const Interval& a, const Interval& b) {
    if (!a.is_bounded() || !b.is_bounded()) { return Interval::all(); }
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return detail::outwards(low, high);
}
inline Interval operator/(const Interval& a, const Interval& b) {
    if (!b.is_bounded() || b.contains(0.0)) { return Interval::all(); }
    return a * detail::outwards(1.0 / b.high, 1.0 / b.low);
}

inline Interval exp(const Interval& x) {
    return x.is_bounded() ? detail::outwards(elementary::exp(x.low), elementary::exp(x.high))
                          : Interval::all();
}
inline Interval log(const Interval& x) {
    if (!x.is_bounded() || x.low <= 0.0) { return Interval::all(); }
    return detail::outwards(elementary::log(x.low), elementary::log(x.high));
}
inline Interval sqrt(const Interval& x) {
    if (!x.is_bounded() || x.low < 0.0) { return Interval::all(); }
    return detail::outwards(std::sqrt(x.low), std::sqrt(x.high));
}
/// Power of a positive number.
inline Interval pow(const Interval& x, double n) {
    if (!x.is_bounded() || x.low <= 0.0) { return Interval::all(); }
    const auto [low, high] = std::minmax({elementary::pow(x.low, n), elementary::pow(x.high, n)});
    return detail::outwards(low, high);
}
inline Interval sin(const Interval& x) {
    if (!x.is_bounded()) { return {-1.0, 1.0}; }
    const auto [low, high] = std::minmax({elementary::sin(x.low), elementary::sin(x.high)});
    Interval out = detail::outwards(low, high);
    if (detail::passes(x, 0.5 * std::numbers::pi)) { out.high = 1.0; }
    if (detail::passes(x, -0.5 * std::numbers::pi)) { out.low = -1.0; }
    return out;
}
inline Interval cos(const Interval& x) {
    if (!x.is_bounded()) { return {-1.0, 1.0}; }
    const auto [low, high] = std::minmax({elementary::cos(x.low), elementary::cos(x.high)});
    Interval out = detail::outwards(low, high);
    if (detail::passes(x, 0.0)) { out.high = 1.0; }
    if (detail::passes(x, std::numbers::pi)) { out.low = -1.0; }
    return out;
}
inline Interval atan(const Interval& x) {
    if (!x.is_bounded()) { return {-2.0, 2.0}; }
    return detail::outwards(elementary::atan(x.low), elementary::atan(x.high));
}
inline Interval asin(const Interval& x) {
    if (!x.is_bounded() || x.magnitude() > 1.0) { return Interval::all(); }
    return detail::outwards(elementary::asin(x.low), elementary::asin(x.high));
}
inline Interval acos(const Interval& x) {
    if (!x.is_bounded() || x.magnitude() > 1.0) { return Interval::all(); }
    return detail::outwards(elementary::acos(x.high), elementary::acos(x.low));
}

}  // namespace jw
