#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/elementary/elementary.hpp"
#include "core/elementary/pair.hpp"

namespace jw::elementary {

namespace {

// ln 2 in two parts, the first of 42 bits after the point: products with exponents are exact
constexpr Pair kLogOfTwo{0x1.62e42fefa3800p-1, 0x1.ef35793c76730p-45};
constexpr Pair kOneOverLogOfTen{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/// Powers of two in steps of 1/64: exp(x) = 2^(n/64) exp(r), with r of at most 2^-7.5, so that roundings of
/// exp(r) - 1 are far below the last place.
constexpr int kPowerSteps = 64;
constexpr double kStepsPerUnit = 0x1.71547652b82fep+6;  // 64 / ln 2
// ln 2 / 64 in two parts, the first of 36 bits
constexpr Pair kPowerStep{0x1.62e42fefa0000p-7, 0x1.cf79abc9e3b3ap-46};

constexpr auto kPowersOfTwo = [] {
    std::array<Pair, kPowerSteps> table{};
    for (int n = 0; n < kPowerSteps; ++n) {
        const Pair x = Pair{1.0 * n, 0.0} * sum_of_ordered(kPowerStep.high, kPowerStep.low);
        Pair term{1.0, 0.0};
        for (int k = 1; k < 28; ++k) {
            table[static_cast<std::size_t>(n)] = table[static_cast<std::size_t>(n)] + term;
            term = term * x / Pair{1.0 * k, 0.0};
        }
    }
    return table;
}();

/// 2^n, n from -1022 to 1023
double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52U); }

/// y 2^n for y from 1 to 2, rounded once
double scaled(const Pair& y, int n) {
    if (n > 1023) { return (y.high + y.low) * 0x1p1023 * power_of_two(n - 1023); }
    if (n > -1022 || (n == -1022 && y.high + y.low >= 1.0)) { return (y.high + y.low) * power_of_two(n); }
    if (n < -1080) { return 0.0; }
    const double unit = power_of_two(n + 1022);
    return rounded_below({y.high * unit, y.low * unit}, 1.0) * 0x1p-1022;
}

/// exp(x.high + x.low), for |x.high| < 1100
double exponential(const Pair& x) {
    const double steps = (x.high * kStepsPerUnit + kRounds) - kRounds;
    const int n = static_cast<int>(steps);
    const double first = x.high - steps * kPowerStep.high;
    const double next = steps * kPowerStep.low;
    const Pair left = sum_of_ordered(first, -next);
    const auto [r, low] = sum_of_ordered(left.high, left.low + x.low);
    const double upper = 1.0 / 24 + r * (1.0 / 120 + r * (1.0 / 720));
    const double less_one = r + (low + r * r * (0.5 + r * (1.0 / 6 + r * upper)));
    const Pair& power = kPowersOfTwo[static_cast<std::size_t>(n & (kPowerSteps - 1))];
    const double rest = power.low + power.high * less_one;
    return scaled({power.high, rest}, n >> 6);
}

/// Entry of the table of logarithms, for numbers near i / 128.
struct LogEntry {
    double inverse = 0.0;  ///< of 11 bits
    Pair log;              ///< of 1 / inverse; `high` has 42 bits after the point
};

/// ln x for x from 0.7 to 1.42, by 2 artanh((x - 1) / (x + 1))
constexpr Pair constant_log(double x) {
    const Pair s = Pair{x - 1.0, 0.0} / Pair{x + 1.0, 0.0};
    const Pair z = s * s;
    Pair power = s + s;
    Pair log;
    for (int k = 0; k < 24; ++k, power = power * z) { log = log + power / Pair{2.0 * k + 1.0, 0.0}; }
    return log;
}

constexpr int kFirst = 90;
constexpr auto kLogs = [] {
    std::array<LogEntry, 182 - kFirst> table{};
    for (int i = 0; i < static_cast<int>(table.size()); ++i) {
        const double inverse = static_cast<int>(1024.0 * 128.0 / (i + kFirst) + 0.5) / 1024.0;
        const Pair log = -constant_log(inverse);
        constexpr double rounds = 1.5 * 0x1p10;  // last bit is 2^-42
        const double high = (log.high + rounds) - rounds;
        table[static_cast<std::size_t>(i)] = {inverse, {high, (log.high - high) + log.low}};
    }
    return table;
}();

/// ln x for positive finite x; relative error below 2^-67
Pair logarithm(double x) {
    int exponent = 0;
    if (x < 0x1p-1022) {
        x *= 0x1p54;
        exponent = -54;
    }
    // x = 2^exponent m, m from 0.707 to 1.414
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto above = static_cast<std::int64_t>(bits - 0x3fe6a09e00000000U);
    exponent += static_cast<int>(above >> 52);
    const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(above >> 52) << 52U));

    // r = m inverse - 1, with 32 bits of m at a time
    const LogEntry& entry = kLogs[static_cast<std::size_t>(static_cast<int>(m * 128.0 + 0.5) - kFirst)];
    const double m_high = std::bit_cast<double>(std::bit_cast<std::uint64_t>(m) & 0xffffffffffe00000U);
    const Pair r = sum(m_high * entry.inverse - 1.0, (m - m_high) * entry.inverse);

    // ln(1 + r) = r - r²/2 + r³/3 ...
    const Pair square = product(r.high, r.high);
    const double x1 = r.high;
    const double upper = -1.0 / 6 + x1 * (1.0 / 7 + x1 * (-1.0 / 8 + x1 * (1.0 / 9)));
    const double series = 1.0 / 3 + x1 * (-1.0 / 4 + x1 * (1.0 / 5 + x1 * upper));
    const Pair begin = sum_of_ordered(exponent * kLogOfTwo.high + entry.log.high, r.high);
    const Pair with_square = sum_of_ordered(begin.high, -0.5 * square.high);
    const double low = (exponent * kLogOfTwo.low + entry.log.low) +
                       (r.low - r.high * r.low - 0.5 * square.low) + r.high * square.high * series;
    return sum_of_ordered(with_square.high, with_square.low + (begin.low + low));
}

/// The logarithm of 0, of negative numbers, of infinity and of NaN.
double unusual_logarithm(double x) {
    if (x == 0.0) { return -kInfinity; }
    return x > 0.0 ? kInfinity : kNotANumber;
}

bool is_usual(double x) { return x > 0.0 && x < kInfinity; }

bool is_integer(double y) { return y == std::floor(y); }
bool is_odd(double y) { return std::abs(y) < 0x1p53 && is_integer(y) && std::fmod(y, 2.0) != 0.0; }

/// x^y where one of them is 0, 1, infinite or NaN; annex F.10.4.4 of the C standard
double unusual_power(double x, double y) {
    if (y == 0.0 || x == 1.0) { return 1.0; }
    if (std::isnan(x) || std::isnan(y)) { return kNotANumber; }
    const double size = std::abs(x);
    if (std::isinf(y)) {
        if (size == 1.0) { return 1.0; }
        return (size > 1.0) == (y > 0.0) ? kInfinity : 0.0;
    }
    // x is 0 or infinite
    const double result = (size > 1.0) == (y > 0.0) ? kInfinity : 0.0;
    return is_odd(y) ? std::copysign(result, x) : result;
}

}  // namespace

double exp(double x) {
    if (std::isnan(x)) { return kNotANumber; }
    if (std::abs(x) > 1000.0) { return x > 0.0 ? kInfinity : 0.0; }
    return exponential({x, 0.0});
}

double log(double x) {
    if (!is_usual(x)) { return unusual_logarithm(x); }
    const Pair log = logarithm(x);
    return log.high + log.low;
}

double log10(double x) {
    if (!is_usual(x)) { return unusual_logarithm(x); }
    const Pair log = logarithm(x) * kOneOverLogOfTen;
    return log.high + log.low;
}

double pow(double x, double y) {
    const double size = std::abs(x);
    if (!is_usual(size) || x == 1.0 || y == 0.0 || !std::isfinite(y)) { return unusual_power(x, y); }
    if (x < 0.0 && !is_integer(y)) { return kNotANumber; }
    const double sign = x < 0.0 && is_odd(y) ? -1.0 : 1.0;
    const Pair log = logarithm(size);
    if (log.high == 0.0) { return sign; }  // x is -1
    const double exponent = y * log.high;
    if (std::abs(exponent) > 1000.0) { return exponent > 0.0 ? sign * kInfinity : sign * 0.0; }
    Pair power = product(y, log.high);
    power.low += y * log.low;
    return sign * exponential(power);
}

}  // namespace jw::elementary
