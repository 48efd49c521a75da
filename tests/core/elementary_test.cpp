#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <numbers>
#include <utility>

#include "core/elementary/elementary.hpp"

using namespace jw;

namespace {

/// Numbers of a sequence that is the same whatever the standard library (Weyl's, mixed as splitmix64 does).
class Sequence {
public:
    explicit Sequence(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
    }
    /// Number of either sign, the exponent of two from `low` to `high` - 1.
    double of_exponent(int low, int high) {
        const double digits = between(1.0, 2.0);
        const double sized = std::ldexp(digits, low + static_cast<int>(between(0, high - low)));
        return bits() % 2 == 0 ? sized : -sized;
    }
    /// Some integer of quarter turns, or a few doubles beside it.
    double near_quarter() {
        double angle = std::floor(between(-1e6, 1e6)) * 0.5 * std::numbers::pi;
        for (std::uint64_t k = bits() % 5; k > 0; --k) { angle = std::nextafter(angle, 1e9); }
        return angle;
    }

private:
    std::uint64_t state_;
};

using Arguments = std::pair<double, double>;

/// Function under test, its right values, and arguments of one kind.
struct Kind {
    const char* name;
    double (*function)(Arguments);
    long double (*right)(Arguments);
    Arguments (*arguments)(Sequence&);
};

long double wide(double x) { return static_cast<long double>(x); }

#define JW_KIND(name, x_of_any)                                                   \
    Kind {                                                                        \
#name " of " #x_of_any, [](Arguments a) { return elementary::name(a.first); },  \
            [](Arguments a) { return std::name(wide(a.first)); },                       \
            [](Sequence& any) { return Arguments{x_of_any, 0.0}; } \
    }
#define JW_KIND_OF_TWO(name, x_of_any, y_of_any)                                  \
    Kind {                                                                        \
#name " of " #x_of_any ", " #y_of_any,                                          \
            [](Arguments a) { return elementary::name(a.first, a.second); },            \
            [](Arguments a) { return std::name(wide(a.first), wide(a.second)); },       \
            [](Sequence& any) {                                                         \
                const double x = x_of_any;                                              \
                return Arguments{x, y_of_any};                                          \
            } \
    }

constexpr std::array kKinds{
    JW_KIND(sin, any.between(-10.0, 10.0)),
    JW_KIND(sin, any.of_exponent(-40, 1023)),
    JW_KIND(sin, any.near_quarter()),
    JW_KIND(cos, any.between(-10.0, 10.0)),
    JW_KIND(cos, any.of_exponent(-40, 1023)),
    JW_KIND(cos, any.near_quarter()),
    JW_KIND(tan, any.between(-10.0, 10.0)),
    JW_KIND(tan, any.of_exponent(-40, 1023)),
    JW_KIND(tan, any.near_quarter()),
    JW_KIND(asin, any.between(-1.0, 1.0)),
    JW_KIND(asin, any.of_exponent(-60, 0)),
    JW_KIND(asin, 1.0 - std::abs(any.of_exponent(-53, 0))),
    JW_KIND(acos, any.between(-1.0, 1.0)),
    JW_KIND(acos, any.of_exponent(-60, 0)),
    JW_KIND(acos, 1.0 - std::abs(any.of_exponent(-53, 0))),
    JW_KIND(acos, std::abs(any.of_exponent(-53, 0)) - 1.0),
    JW_KIND(atan, any.between(-3.0, 3.0)),
    JW_KIND(atan, any.of_exponent(-60, 60)),
    JW_KIND_OF_TWO(atan2, any.between(-1.0, 1.0), any.between(-1.0, 1.0)),
    JW_KIND_OF_TWO(atan2, any.of_exponent(-40, 40), any.of_exponent(-40, 40)),
    JW_KIND_OF_TWO(atan2, any.of_exponent(-1074, 1023), any.of_exponent(-1074, 1023)),
    JW_KIND_OF_TWO(atan2, any.of_exponent(960, 1023), any.of_exponent(960, 1023)),
    JW_KIND_OF_TWO(atan2, any.of_exponent(-1074, -1020), any.of_exponent(-1074, -1020)),
    JW_KIND(exp, any.between(-1.0, 1.0)),
    JW_KIND(exp, any.between(-746.0, 709.7)),
    JW_KIND(exp, any.between(-746.0, -707.0)),
    JW_KIND(exp, any.of_exponent(-60, 0)),
    JW_KIND(log, any.between(0.0, 4.0)),
    JW_KIND(log, std::abs(any.of_exponent(-1074, 1023))),
    JW_KIND(log, 1.0 + any.of_exponent(-52, -2)),
    JW_KIND(log10, any.between(0.0, 4.0)),
    JW_KIND(log10, std::abs(any.of_exponent(-1074, 1023))),
    JW_KIND(log10, 1.0 + any.of_exponent(-52, -2)),
    JW_KIND_OF_TWO(pow, any.between(0.0, 4.0), any.between(-10.0, 10.0)),
    JW_KIND_OF_TWO(pow, std::abs(any.of_exponent(-1074, 1023)), any.of_exponent(-10, 0)),
    JW_KIND_OF_TWO(pow, 1.0 + any.of_exponent(-40, -3), any.between(-745.0, 709.0) / elementary::log(x)),
    JW_KIND_OF_TWO(pow, any.between(-4.0, 0.0), std::floor(any.between(-100.0, 100.0))),
    JW_KIND_OF_TWO(hypot, any.between(-1.0, 1.0), any.between(-1.0, 1.0)),
    JW_KIND_OF_TWO(hypot, any.of_exponent(-30, 30), any.of_exponent(-30, 30)),
    JW_KIND_OF_TWO(hypot, any.of_exponent(-1074, 1022), any.of_exponent(-1074, 1022)),
    JW_KIND_OF_TWO(hypot, any.of_exponent(-1074, -1020), any.of_exponent(-1074, -1020))};

/// Distance from `right` in units of the last place that a double of its size has.
double error_in_last_places(double found, long double right) {
    const double rounded = static_cast<double>(right);
    if (!std::isfinite(rounded) || !std::isfinite(found)) {
        return found == rounded ? 0.0 : std::numeric_limits<double>::infinity();
    }
    int exponent = 0;
    std::frexp(right, &exponent);
    return static_cast<double>(
        std::abs(wide(found) - right) * std::ldexp(1.0L, 53 - std::max(exponent, -1021)));
}

/// Number of arguments of each kind: in all about a million for each function.
constexpr int kOfEachKind = 350'000;

}  // namespace

TEST_CASE("Elementary functions are wrong by at most 0.52 units in the last place", "[core][elementary]") {
    static_assert(std::numeric_limits<long double>::digits >= 64);
    // 0.5 is the last rounding, 0.015 the error before it; the functions of long double add 2^-11
    for (const Kind& kind : kKinds) {
        Sequence any(21);
        double worst = 0.0;
        Arguments where;
        for (int k = 0; k < kOfEachKind; ++k) {
            const Arguments a = kind.arguments(any);
            const double error = error_in_last_places(kind.function(a), kind.right(a));
            if (!(error <= worst)) {
                worst = error;
                where = a;
            }
        }
        std::cout << worst << " units in the last place: " << kind.name << '\n';
        CAPTURE(kind.name, where.first, where.second);
        CHECK(worst < 0.52);
    }
}

TEST_CASE("Elementary functions have the same bits on every machine", "[core][elementary]") {
    std::uint64_t all = 0;
    for (const Kind& kind : kKinds) {
        Sequence any(22);
        for (int k = 0; k < 10'000; ++k) {
            const double found = kind.function(kind.arguments(any));
            all = (all ^ std::bit_cast<std::uint64_t>(found)) * 0x100000001b3U;
        }
    }
    CHECK(all == 0x420571b19bc7aa77U);
}

TEST_CASE("Sine and cosine together are those of each alone", "[core][elementary]") {
    Sequence any(23);
    for (int k = 0; k < 100'000; ++k) {
        const double angle = k % 3 == 0 ? any.near_quarter() : any.of_exponent(-40, k % 3 == 1 ? 4 : 1023);
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        REQUIRE(sine == elementary::sin(angle));
        REQUIRE(cosine == elementary::cos(angle));
    }
}

TEST_CASE("Elementary functions are exact where their result is a number", "[core][elementary]") {
    double power_of_ten = 1.0;
    for (int n = 0; n <= 22; ++n, power_of_ten *= 10.0) {
        CHECK(elementary::pow(10.0, n) == power_of_ten);
        CHECK(elementary::log10(power_of_ten) == n);
    }
    for (int n = -1074; n <= 1023; ++n) {
        REQUIRE(elementary::pow(2.0, n) == std::ldexp(1.0, n));
        REQUIRE(elementary::hypot(3.0 * std::ldexp(1.0, n), 0.0) == 3.0 * std::ldexp(1.0, n));
    }
    for (const double unit : {1.0, 0x1p-1070, 0x1p1018}) {
        CHECK(elementary::hypot(3.0 * unit, -4.0 * unit) == 5.0 * unit);
        CHECK(elementary::hypot(-8.0 * unit, 15.0 * unit) == 17.0 * unit);
    }
    CHECK(elementary::pow(-3.0, 5.0) == -243.0);
    CHECK(elementary::pow(9.0, 0.5) == 3.0);
    CHECK(elementary::acos(1.0) == 0.0);
    CHECK(elementary::exp(0.0) == 1.0);
    CHECK(elementary::log(1.0) == 0.0);
    CHECK(elementary::cos(0.0) == 1.0);
}

TEST_CASE("Elementary functions have the special values of the C standard", "[core][elementary]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr std::array special{
        0.0,  -0.0,  1.0,          -1.0,          0.5,           -0.5,  2.0,    -2.0,    3.0,
        -3.0, 2.5,   infinity,     -infinity,     nan,           least, -least, largest, -largest,
        1e17, -1e17, 0x1p53 - 1.0, 1.0 - 0x1p-53, 1.0 + 0x1p-52, 710.0, -746.0};
    // the sign of zero counts
    const auto check = [](const char* name, double x, double y, double found, long double right) {
        const double rounded = static_cast<double>(right);
        CAPTURE(name, x, y, found, rounded);
        CHECK(std::isnan(found) == std::isnan(rounded));
        if (std::isnan(rounded)) { return; }
        CHECK(std::signbit(found) == std::signbit(rounded));
        CHECK(error_in_last_places(found, right) < 0.52);
    };
    const auto check_one = [&]<class Found, class Right>(const char* name, Found found, Right right) {
        for (const double x : special) { check(name, x, 0.0, found(x), right(wide(x))); }
    };
    const auto check_two = [&]<class Found, class Right>(const char* name, Found found, Right right) {
        for (const double x : special) {
            for (const double y : special) { check(name, x, y, found(x, y), right(wide(x), wide(y))); }
        }
    };
    using Wide = long double;
    check_one("sin", elementary::sin, [](Wide x) { return std::sin(x); });
    check_one("cos", elementary::cos, [](Wide x) { return std::cos(x); });
    check_one("tan", elementary::tan, [](Wide x) { return std::tan(x); });
    check_one("asin", elementary::asin, [](Wide x) { return std::asin(x); });
    check_one("acos", elementary::acos, [](Wide x) { return std::acos(x); });
    check_one("atan", elementary::atan, [](Wide x) { return std::atan(x); });
    check_one("exp", elementary::exp, [](Wide x) { return std::exp(x); });
    check_one("log", elementary::log, [](Wide x) { return std::log(x); });
    check_one("log10", elementary::log10, [](Wide x) { return std::log10(x); });
    check_two("atan2", elementary::atan2, [](Wide y, Wide x) { return std::atan2(y, x); });
    check_two("pow", elementary::pow, [](Wide x, Wide y) { return std::pow(x, y); });
    check_two("hypot", elementary::hypot, [](Wide x, Wide y) { return std::hypot(x, y); });
}
