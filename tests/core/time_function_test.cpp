#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/jets/time_function.hpp"
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
