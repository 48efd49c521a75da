#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/numerics/sine_cosine.hpp"
#include "core/numerics/triples.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

std::vector<FourTurns> turns_by(const std::vector<double>& angles, Registers registers = widest_registers()) {
    std::vector<FourTurns> turns((angles.size() + 3) / 4);
    for (std::size_t k = 0; k < angles.size(); ++k) { turns[k / 4].angle[k % 4] = angles[k]; }
    find_sines_and_cosines(turns, registers);
    return turns;
}

double largest_error(const std::vector<double>& angles) {
    const std::vector<FourTurns> turns = turns_by(angles);
    long double worst = 0.0L;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const auto angle = static_cast<long double>(angles[k]);
        const FourTurns& four = turns[k / 4];
        worst = std::max(worst, std::abs(std::cos(angle) - static_cast<long double>(four.cosine[k % 4])));
        worst = std::max(worst, std::abs(std::sin(angle) - static_cast<long double>(four.sine[k % 4])));
    }
    return static_cast<double>(worst);
}

/// Half a unit in the last place of numbers near 1 is 5.6e-17; sums of the polynomials take as much again.
constexpr double kRounding = 1.2e-16;

}  // namespace

TEST_CASE("Sines and cosines of angles near and far are right to rounding", "[core][dynamics]") {
    test::Random random(11);
    for (const double range : {1e-8, 1e-3, 1.0, 10.0, 1e3, 1.5e6, 1e9, 1e15}) {
        CAPTURE(range);
        std::vector<double> angles;
        for (int k = 0; k < 20'000; ++k) { angles.push_back(random.number(-range, range)); }
        CHECK(largest_error(angles) < kRounding);
    }
}

TEST_CASE("Sines and cosines beside quarter turns keep all their digits", "[core][dynamics]") {
    std::vector<double> angles;
    for (int quarters = -2000; quarters <= 2000; ++quarters) {
        double angle = quarters * 0.5 * std::numbers::pi;
        for (int k = 0; k < 3; ++k) {
            angles.push_back(angle);
            angle = std::nextafter(angle, 1e9);
        }
    }
    for (double quarters = 1e6; quarters < 1.018e6; ++quarters) {
        angles.push_back(quarters * 0.5 * std::numbers::pi);
    }
    CHECK(largest_error(angles) < kRounding);
    // relative to their own size, for small values too
    const std::vector<FourTurns> turns = turns_by(angles);
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const auto angle = static_cast<long double>(angles[k]);
        for (const auto& [found, right] :
             {std::pair{turns[k / 4].sine[k % 4], std::sin(angle)},
              std::pair{turns[k / 4].cosine[k % 4], std::cos(angle)}}) {
            const long double error = std::abs(static_cast<long double>(found) - right);
            // three parts of π/2 leave out 2^-99 of it, up to a million times
            if (error > 4e-16L * std::abs(right) + 1e-24L) { FAIL_CHECK("at " << angles[k]); }
        }
    }
}

TEST_CASE("Sines and cosines are the same to the last bit whatever registers there are", "[core][dynamics]") {
    test::Random random(12);
    std::vector<double> angles;
    for (int k = 0; k < 10'000; ++k) { angles.push_back(random.number(-1e3, 1e3)); }
    const std::vector<FourTurns> wide = turns_by(angles);
    const std::vector<FourTurns> narrow = turns_by(angles, Registers::narrow);
    for (std::size_t k = 0; k < angles.size(); ++k) {
        REQUIRE(wide[k / 4].sine[k % 4] == narrow[k / 4].sine[k % 4]);
        REQUIRE(wide[k / 4].cosine[k % 4] == narrow[k / 4].cosine[k % 4]);
    }
}

TEST_CASE("Of an angle that is no number neither sine nor cosine is one", "[core][dynamics]") {
    for (const double angle : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        const std::vector<FourTurns> turns = turns_by({0.0, angle});
        CHECK(std::isnan(turns[0].sine[1]));
        CHECK(std::isnan(turns[0].cosine[1]));
        CHECK(turns[0].cosine[0] == 1.0);
    }
}
