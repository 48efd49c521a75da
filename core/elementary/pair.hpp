#pragma once

#include <cmath>
#include <limits>

/// Numbers with twice the digits: sums of two doubles (Dekker, Knuth). With them, a function is computed to
/// some 70 bits and rounded once, and its tables are computed at compile time.
namespace jw::elementary {

/// high + low; normalised: low is at most half a unit in the last place of high.
struct Pair {
    double high = 0.0;
    double low = 0.0;
};

/// a + b without error, where |a| >= |b| or a is 0.
constexpr Pair sum_of_ordered(double a, double b) {
    const double high = a + b;
    return {high, b - (high - a)};
}

/// a + b without error.
constexpr Pair sum(double a, double b) {
    const double high = a + b;
    const double of_b = high - a;
    return {high, (a - (high - of_b)) + (b - of_b)};
}

/// a in two parts of at most 26 bits; |a| < 2^995.
constexpr Pair halves(double a) {
    const double scaled = 134217729.0 * a;  // 2^27 + 1
    const double high = scaled - (scaled - a);
    return {high, a - high};
}

/// a b without error, unless a or b overflows in `halves` or the error underflows.
constexpr Pair product(double a, double b) {
    const Pair x = halves(a);
    const Pair y = halves(b);
    const double high = a * b;
    return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr Pair operator-(const Pair& a) { return {-a.high, -a.low}; }
constexpr Pair operator+(const Pair& a, const Pair& b) {
    const Pair s = sum(a.high, b.high);
    return sum_of_ordered(s.high, s.low + (a.low + b.low));
}
constexpr Pair operator*(const Pair& a, const Pair& b) {
    const Pair p = product(a.high, b.high);
    return sum_of_ordered(p.high, p.low + (a.high * b.low + a.low * b.high));
}
constexpr Pair operator/(const Pair& a, const Pair& b) {
    const double quotient = a.high / b.high;
    const Pair p = product(quotient, b.high);
    const double rest = ((a.high - p.high) - p.low) + a.low - quotient * b.low;
    return sum_of_ordered(quotient, rest / b.high);
}

/// Square root of a positive number.
inline Pair square_root(const Pair& a) {
    const double root = std::sqrt(a.high);
    const Pair square = product(root, root);
    return sum_of_ordered(root, (((a.high - square.high) - square.low) + a.low) / (2.0 * root));
}

/// a, rounded once to the last place of `power`, a power of two above |a|: in this way, very small numbers
/// lose the digits that a double cannot hold.
constexpr double rounded_below(const Pair& a, double power) {
    const Pair s = sum_of_ordered(power, a.high);
    return (s.high + (s.low + a.low)) - power;
}

/// 1.5 · 2^52: adding it rounds a number to an integer, which is then in the last bits.
constexpr double kRounds = 6755399441055744.0;

constexpr Pair kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Pair kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace jw::elementary
