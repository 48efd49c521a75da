#include <array>
#include <cmath>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/elementary/pair.hpp"

namespace jw::elementary {

namespace {

/// Steps of the table per unit of q: atan q = atan a + atan d, d = (q - a) / (1 + q a), with d of at most
/// 2^-9, so that roundings of d are far below the last place of the sum.
constexpr int kArcSteps = 256;
/// Tangent from which the table is used: below it, atan q is q plus a small rest by the power series.
constexpr double kSmallTangent = 0.125;

/// atan of at most 2^-8, by its power series
constexpr Pair small_arc(const Pair& x) {
    const Pair z = x * x;
    Pair power = x;
    Pair arc;
    for (int k = 0; k < 8; ++k, power = power * -z) { arc = arc + power / Pair{2.0 * k + 1.0, 0.0}; }
    return arc;
}

/// atan of k / kArcSteps: each differs from the previous one by the arc of a small tangent
constexpr auto kArcs = [] {
    std::array<Pair, kArcSteps + 1> table{};
    for (int k = 0; k < kArcSteps; ++k) {
        const Pair step =
            small_arc(Pair{1.0 * kArcSteps, 0.0} / Pair{1.0 * kArcSteps * kArcSteps + k * (k + 1.0), 0.0});
        table[static_cast<std::size_t>(k) + 1] = table[static_cast<std::size_t>(k)] + step;
    }
    return table;
}();

/// atan(y / x) + rest for 0 <= y <= x, x between 2^-900 and 2^900; not normalised
Pair eighth_turn(double y, double x, double rest) {
    const double q = y / x;
    if (q < kSmallTangent) {
        const double z = q * q;
        const Pair p = product(q, x);
        const double left = ((y - p.high) - p.low) / x * (1.0 - z);
        const double last = z * (1.0 / 17 + z * (-1.0 / 19 + z * (1.0 / 21)));
        const double upper = z * (-1.0 / 11 + z * (1.0 / 13 + z * (-1.0 / 15 + last)));
        const double series = -1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + upper)));
        return {q, q * z * series + (left + rest)};
    }
    const int k = static_cast<int>(q * kArcSteps + 0.5);
    const double a = k * (1.0 / kArcSteps);
    const Pair parts = halves(x);
    const double d = ((y - a * parts.high) - a * parts.low) / (x + a * y);
    const double z = d * d;
    const Pair& entry = kArcs[static_cast<std::size_t>(k)];
    return {entry.high, d + (d * z * (-1.0 / 3 + z * (1.0 / 5)) + (entry.low + rest))};
}

/// a - b
Pair difference(const Pair& a, const Pair& b) {
    const Pair s = sum(a.high, -b.high);
    return {s.high, s.low + (a.low - b.low)};
}

/// atan(y / x) + rest for y >= 0 and x >= 0, not both 0
Pair quarter_turn(double y, double x, double rest) {
    return y <= x ? eighth_turn(y, x, rest) : difference(kHalfPi, eighth_turn(x, y, -rest));
}

double rounded(const Pair& a) { return a.high + a.low; }

/// sqrt(1 - x²), |x| <= 1
Pair other_side(double x) {
    const Pair square = sum(1.0, -x) * sum(1.0, x);
    return square.high > 0.0 ? square_root(square) : Pair{};
}

/// atan2 of positive finite numbers; not normalised
Pair first_quarter(double y, double x) {
    const double larger = y > x ? y : x;
    // scaled so that parts of products neither overflow nor vanish
    if (larger > 0x1p900) {
        y *= 0x1p-200;
        x *= 0x1p-200;
    } else if (larger < 0x1p-800) {
        y *= 0x1p200;
        x *= 0x1p200;
    }
    return quarter_turn(y, x, 0.0);
}

/// Below this ratio, the arc is the ratio itself, or differs from a quarter turn by the ratio.
constexpr double kTiny = 0x1p-60;

/// Angle in the first quarter, for positive numbers; one of them may be infinite, or one may be 0.
Pair angle_of(double y, double x) {
    if (y == x) { return {0.5 * kHalfPi.high, 0.5 * kHalfPi.low}; }
    if (y < kTiny * x) { return {y / x, 0.0}; }
    if (x < kTiny * y) { return {kHalfPi.high, kHalfPi.low - x / y}; }
    return first_quarter(y, x);
}

}  // namespace

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) { return kNotANumber; }
    const double up = std::abs(y);
    const double along = std::abs(x);
    Pair angle;
    if (up > 0.0 || along > 0.0) { angle = angle_of(up, along); }
    if (std::signbit(x)) { angle = difference(kPi, angle); }
    return std::copysign(rounded(angle), y);
}

double atan(double x) {
    if (std::isnan(x)) { return kNotANumber; }
    return std::copysign(rounded(angle_of(std::abs(x), 1.0)), x);
}

// the triangle has the legs x and c = sqrt(1 - x²); a change dc changes the angle opposite x by -x dc

double asin(double x) {
    if (!(std::abs(x) <= 1.0)) { return kNotANumber; }
    const double size = std::abs(x);
    if (size < 0x1p-30) { return x; }
    const Pair c = other_side(size);
    return std::copysign(rounded(quarter_turn(size, c.high, -size * c.low)), x);
}

double acos(double x) {
    if (!(std::abs(x) <= 1.0)) { return kNotANumber; }
    const double size = std::abs(x);
    const Pair c = other_side(size);
    const Pair angle = quarter_turn(c.high, size, size * c.low);
    return rounded(x < 0.0 ? difference(kPi, angle) : angle);
}

double hypot(double x, double y) {
    double a = std::abs(x);
    double b = std::abs(y);
    if (std::isinf(a) || std::isinf(b)) { return kInfinity; }
    if (std::isnan(a) || std::isnan(b)) { return kNotANumber; }
    if (a < b) { std::swap(a, b); }
    if (b <= a * 0x1p-54) { return a; }
    // scaled so that squares neither overflow nor lose digits
    double scale = 1.0;
    if (a > 0x1p450) {
        scale = 0x1p-600;
    } else if (b < 0x1p-450) {
        scale = 0x1p600;
    }
    a *= scale;
    b *= scale;
    const Pair root = square_root(product(a, a) + product(b, b));
    const double least = 0x1p-1022 * scale;
    return (root.high < least ? rounded_below(root, least) : root.high + root.low) / scale;
}

}  // namespace jw::elementary
