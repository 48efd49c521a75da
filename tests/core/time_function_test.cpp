#include <catch2/catch.hpp>

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
