#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/jets/time_function.hpp"
#include "tests/reference/natural_spline.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

// closed forms of a dozen operations on numbers up to 10
constexpr double kRoundingOfTime = 1e-14;

}  // namespace

TEST_CASE("A time function without parts is zero with zero derivatives", "[core][time_function]") {
    const TimeFunction::Value value = TimeFunction{}.at(2.5);
    CHECK(value.f == 0.0);
    CHECK(value.f_dot == 0.0);
    CHECK(value.f_ddot == 0.0);
}

TEST_CASE("A polynomial has the value and the derivatives of school", "[core][time_function]") {
    TimeFunction f;
    f.polynomial = {1.0, -2.0, 3.0, 0.5};
    const double t = GENERATE(-1.5, 0.0, 0.3, 2.0);
    CAPTURE(t);
    const TimeFunction::Value value = f.at(t);
    CHECK(std::abs(value.f - (1.0 - 2.0 * t + 3.0 * t * t + 0.5 * t * t * t)) < kRoundingOfTime);
    CHECK(std::abs(value.f_dot - (-2.0 + 6.0 * t + 1.5 * t * t)) < kRoundingOfTime);
    CHECK(std::abs(value.f_ddot - (6.0 + 3.0 * t)) < kRoundingOfTime);
}

TEST_CASE("Harmonics add up, each with its amplitude, frequency and phase", "[core][time_function]") {
    TimeFunction f;
    f.harmonics = {{2.0, 3.0, 0.5}, {-0.7, 0.4, std::numbers::pi / 2.0}};
    const double t = GENERATE(-1.0, 0.0, 0.8);
    CAPTURE(t);
    const TimeFunction::Value value = f.at(t);
    // sin(x + π/2) = cos x
    CHECK(std::abs(value.f - (2.0 * std::sin(3.0 * t + 0.5) - 0.7 * std::cos(0.4 * t))) < kRoundingOfTime);
    CHECK(
        std::abs(value.f_dot - (6.0 * std::cos(3.0 * t + 0.5) + 0.28 * std::sin(0.4 * t))) < kRoundingOfTime);
    CHECK(
        std::abs(value.f_ddot - (-18.0 * std::sin(3.0 * t + 0.5) + 0.112 * std::cos(0.4 * t))) <
        2.0 * kRoundingOfTime);
}

TEST_CASE(
    "A smooth step rests before and after, passes its middle at half time and is symmetric",
    "[core][time_function]") {
    TimeFunction f;
    f.steps = {{1.0, 4.0, 0.5, 2.5}};
    for (const double t : {-3.0, 0.0, 0.5}) {
        CHECK(f.at(t).f == 1.0);
        CHECK(f.at(t).f_dot == 0.0);
        CHECK(f.at(t).f_ddot == 0.0);
    }
    for (const double t : {2.5, 9.0}) {
        CHECK(f.at(t).f == 4.0);
        CHECK(f.at(t).f_dot == 0.0);
        CHECK(f.at(t).f_ddot == 0.0);
    }
    CHECK(std::abs(f.at(1.5).f - 2.5) < kRoundingOfTime);
    CHECK(std::abs(f.at(1.5).f_dot - 15.0 / 8.0 * 3.0 / 2.0) < kRoundingOfTime);  // 30/16 rise / duration
    CHECK(std::abs(f.at(1.5).f_ddot) < kRoundingOfTime);
    for (const double s : {0.1, 0.45, 0.9}) {
        CAPTURE(s);
        CHECK(std::abs(f.at(1.5 + s).f + f.at(1.5 - s).f - 5.0) < kRoundingOfTime);
    }
}

TEST_CASE(
    "A smooth step and both derivatives are continuous where it begins and ends", "[core][time_function]") {
    TimeFunction f;
    f.steps = {{-1.0, 2.0, 1.0, 3.0}};
    const double end = GENERATE(1.0, 3.0);
    for (const double h : {1e-3, 1e-5, 1e-7}) {
        CAPTURE(end, h);
        const TimeFunction::Value before = f.at(end - h);
        const TimeFunction::Value after = f.at(end + h);
        // near an end: f ~ 10 rise (h/T)³, so f̈ ~ 60 rise h/T³ = 22.5 h; 1e-14: rounding of 1 - u
        CHECK(std::abs(after.f - before.f) <= 4.0 * h * h * h + 1e-14);
        CHECK(std::abs(after.f_dot - before.f_dot) <= 12.0 * h * h + 1e-14);
        CHECK(std::abs(after.f_ddot - before.f_ddot) <= 23.0 * h + 1e-14);
    }
}

TEST_CASE("The derivatives of any sum of parts are those of differences", "[core][time_function]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        const TimeFunction f = test::random_function(random);
        const double t = random.number(-0.4, 1.4);
        CAPTURE(seed, t);
        // order 4: truncation h⁴ f⁽⁵⁾/30 with f⁽⁵⁾ < 1e3 gives 3e-11, rounding 1e-15/h 1e-12
        const double h = 1e-3;
        const auto value = [&](double at) { return f.at(at).f; };
        const auto rate = [&](double at) { return f.at(at).f_dot; };
        const auto difference = [&](const auto& g) {
            return (8.0 * (g(t + h) - g(t - h)) - (g(t + 2.0 * h) - g(t - 2.0 * h))) / (12.0 * h);
        };
        CHECK(std::abs(f.at(t).f_dot - difference(value)) < 1e-9);
        CHECK(std::abs(f.at(t).f_ddot - difference(rate)) < 1e-9);
    }
}

TEST_CASE("Bounds of derivatives are reached by what is bounded", "[core][time_function]") {
    // |f'|, |f''| / 2, |f'''| / 6 and |f''''| / 24 over an interval
    const auto check = [](const TimeFunction& f, double from, double to, std::array<double, 4> expected) {
        const std::array<double, 5> bounds = f.taylor_bounds(from, to);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            CAPTURE(k + 1);
            CHECK(bounds[k + 1] == Approx(expected[k]).epsilon(1e-4));
        }
    };
    TimeFunction polynomial;
    polynomial.polynomial = {7.0, 2.0, -3.0, 0.0, 5.0, 1.0};
    // 2 + 2 3 t + 4 5 t³ + 5 t⁴ at t = 2, each term with its size
    check(polynomial, -2.0, 1.0, {254.0, 203.0, 80.0, 15.0});
    TimeFunction harmonics;
    harmonics.harmonics = {{-2.0, 3.0, 0.4}, {0.5, -2.0, 0.0}};
    check(harmonics, 0.0, 10.0, {7.0, 10.0, 58.0 / 6.0, 170.0 / 24.0});
    TimeFunction step;
    step.steps = {{1.0, 4.0, 0.5, 2.5}};
    const double third = 10.0 / std::sqrt(3.0);
    check(step, 0.5, 2.5, {3.0 * 1.875 / 2.0, 3.0 * third / 8.0, 3.0 * 60.0 / 48.0, 3.0 * 360.0 / 384.0});
    check(step, -1.0, 0.5, {0.0, 0.0, 0.0, 0.0});
    check(step, 2.5, 3.0, {0.0, 0.0, 0.0, 0.0});
    for (const auto& [from, to] : {std::array{0.4, 0.6}, std::array{2.4, 2.6}}) {
        const std::array<double, 5> bounds = step.taylor_bounds(from, to);
        CHECK(bounds[3] == Approx(3.0 * 60.0 / 48.0));
        CHECK(std::isinf(bounds[4]));
    }
    // largest derivatives, sampled: the quintic's second one is reached within
    double second = 0.0;
    for (int k = 0; k <= 1000; ++k) { second = std::max(second, std::abs(step.at(0.5 + 0.002 * k).f_ddot)); }
    CHECK(second / 2.0 == Approx(step.taylor_bounds(0.5, 2.5)[2]).epsilon(1e-4));
}

namespace {

using Interpolation = TimeTable::Interpolation;

/// Up to a dozen values at times from 1e-3 to 1 s apart.
TimeTable any_table(test::Random& random, Interpolation interpolation) {
    const auto count = static_cast<std::size_t>(random.number(2.0, 12.99));
    std::vector<double> times{random.number()};
    std::vector<double> values{random.number()};
    while (times.size() < count) {
        times.push_back(times.back() + std::pow(10.0, random.number(-3.0, 0.0)));
        // some stay where they are
        values.push_back(random.number() < -0.5 ? values.back() : random.number());
    }
    return table_through(times, values, interpolation);
}

/// Largest |rate| and |second derivative| of all pieces, as a measure of what rounding changes.
double size_of(const TimeTable& table) {
    double size = 1.0;
    for (std::size_t k = 0; k <= table.times.size(); ++k) {
        for (const double c : table.piece(k).c) { size = std::max(size, std::abs(c)); }
    }
    return size;
}

}  // namespace

TEST_CASE("A smooth table is the natural cubic spline, solved in another way", "[core][time_function]") {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        test::Random random(seed);
        TimeFunction f;
        f.table = any_table(random, Interpolation::smooth);
        const double t = random.number(f.table->times.front() - 0.5, f.table->times.back() + 0.5);
        CAPTURE(seed, t, f.table->times, f.table->values);
        const auto expected = reference::natural_spline_at<long double>(f.table->times, f.table->values, t);
        const TimeFunction::Value found = f.at(t);
        // a dozen operations; neighbours up to 1000 times as far apart as others
        const double rounding = 1e-14 * size_of(*f.table);
        CHECK(std::abs(found.f - static_cast<double>(expected[0])) < rounding);
        CHECK(std::abs(found.f_dot - static_cast<double>(expected[1])) < rounding);
        CHECK(std::abs(found.f_ddot - static_cast<double>(expected[2])) < 10.0 * rounding);
    }
}

TEST_CASE("A monotone table stays between the two values beside it", "[core][time_function]") {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        test::Random random(seed);
        TimeFunction f;
        f.table = any_table(random, Interpolation::monotone);
        CAPTURE(seed, f.table->times, f.table->values);
        const std::vector<double>& times = f.table->times;
        const std::vector<double>& values = f.table->values;
        for (std::size_t k = 1; k < times.size(); ++k) {
            const auto [low, high] = std::minmax(values[k - 1], values[k]);
            double before = values[k - 1];
            for (int n = 0; n <= 20; ++n) {
                const double now = f.at(times[k - 1] + (times[k] - times[k - 1]) * n / 20.0).f;
                // rounding of values up to 1
                CHECK(now >= low - 1e-15);
                CHECK(now <= high + 1e-15);
                CHECK((now - before) * (values[k] - values[k - 1]) >= -1e-15);
                before = now;
            }
        }
    }
}

TEST_CASE("A monotone table of a parabola has its rates at the ends", "[core][time_function]") {
    const TimeTable table = table_through({1.0, 2.0, 4.0}, {1.0, 4.0, 16.0}, Interpolation::monotone);
    CHECK(table.rates[0] == Approx(2.0));
    CHECK(table.rates[2] == Approx(8.0));
    // (5 + 4) / (5/3 + 4/6), the weighted harmonic mean of the mean rates 3 and 6
    CHECK(table.rates[1] == Approx(27.0 / 7.0));
}

TEST_CASE("A table passes its values with a continuous rate, and goes on straight", "[core][time_function]") {
    for (const Interpolation interpolation : {Interpolation::smooth, Interpolation::monotone}) {
        for (unsigned seed = 1; seed <= 200; ++seed) {
            test::Random random(seed);
            TimeFunction f;
            f.table = any_table(random, interpolation);
            CAPTURE(seed, f.table->times, f.table->values);
            const double size = size_of(*f.table);
            for (std::size_t k = 0; k < f.table->times.size(); ++k) {
                const double t = f.table->times[k];
                const double h = 1e-9;
                CHECK(std::abs(f.at(t).f - f.table->values[k]) < 1e-14 * size);
                CHECK(std::abs(f.at(t - h).f - f.table->values[k]) < 2.0 * h * size);
                CHECK(std::abs(f.at(t - h).f_dot - f.at(t).f_dot) < 10.0 * h * size);
                if (interpolation == Interpolation::smooth) {
                    CHECK(std::abs(f.at(t - h).f_ddot - f.at(t).f_ddot) < 1e-7 * size);
                }
            }
            const auto last = f.at(f.table->times.back());
            // the last time belongs to the table
            CHECK(last.f == Approx(f.table->values.back()).margin(1e-14));
            CHECK(last.f_ddot == Approx(f.at(f.table->times.back() - 1e-9).f_ddot).margin(1e-6 * size));
            const auto beyond = f.at(f.table->times.back() + 0.5);
            CHECK(beyond.f == Approx(last.f + 0.5 * last.f_dot));
            CHECK(beyond.f_dot == Approx(last.f_dot).margin(1e-14 * size));
            CHECK(beyond.f_ddot == 0.0);
        }
    }
}

TEST_CASE("Bounds of a table hold, and are infinite where a derivative jumps", "[core][time_function]") {
    for (const Interpolation interpolation : {Interpolation::smooth, Interpolation::monotone}) {
        for (unsigned seed = 1; seed <= 500; ++seed) {
            test::Random random(seed);
            TimeFunction f;
            f.table = any_table(random, interpolation);
            const std::vector<double>& times = f.table->times;
            const double from = random.number(times.front() - 0.3, times.back());
            const double to = from + random.number(0.0, 1.0);
            CAPTURE(seed, from, to, times, f.table->values);
            const std::array<double, 5> bounds = f.taylor_bounds(from, to);
            double rate = 0.0;
            double second = 0.0;
            for (int n = 0; n <= 500; ++n) {
                const TimeFunction::Value value = f.at(from + (to - from) * n / 500.0);
                rate = std::max(rate, std::abs(value.f_dot));
                second = std::max(second, std::abs(value.f_ddot));
            }
            CHECK(rate <= bounds[1] * (1.0 + 1e-12));
            CHECK(second / 2.0 <= bounds[2] * (1.0 + 1e-12));
            const bool jumps = std::ranges::any_of(times, [&](double t) { return t > from && t < to; });
            CHECK((bounds[4] == HUGE_VAL) == jumps);
            CHECK((bounds[3] == HUGE_VAL) == (jumps && interpolation == Interpolation::monotone));
            // reached on a piece that bends one way
            const std::array<double, 5> alone = f.taylor_bounds(times[0], times[1]);
            const auto c = f.table->piece(1).c;
            const double u = times[1] - times[0];
            CHECK(
                alone[1] == Approx(std::abs(c[1]) + 2.0 * std::abs(c[2]) * u + 3.0 * std::abs(c[3]) * u * u));
            CHECK(alone[2] == Approx(std::abs(c[2]) + 3.0 * std::abs(c[3]) * u));
            CHECK(alone[3] == std::abs(c[3]));
            CHECK(alone[4] == 0.0);
        }
    }
}

TEST_CASE("Times that do not increase, or lack a value, are no table", "[core][time_function]") {
    const auto make = [](std::vector<double> times, std::vector<double> values) {
        return table_through(std::move(times), std::move(values), Interpolation::smooth);
    };
    CHECK_THROWS_AS(make({0.0}, {1.0}), std::invalid_argument);
    CHECK_THROWS_AS(make({0.0, 1.0}, {1.0}), std::invalid_argument);
    CHECK_THROWS_AS(make({0.0, 0.0}, {1.0, 2.0}), std::invalid_argument);
    CHECK_THROWS_AS(make({0.0, 1.0, 0.5}, {1.0, 2.0, 3.0}), std::invalid_argument);
}
