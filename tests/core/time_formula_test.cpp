#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/jets/time_formula.hpp"
#include "tests/support/formula_value.hpp"
#include "tests/support/random_mechanisms.hpp"

namespace jw {

namespace {

using Kind = FormulaStep::Kind;
using Real = long double;
using Function = std::function<Real(Real)>;

/// Steps of generated formulas.
class Author {
public:
    explicit Author(unsigned seed) : random_(seed) {}

    std::vector<FormulaStep> formula(int depth) {
        if (depth == 0) { return leaf(); }
        constexpr std::array kinds{Kind::negative,    Kind::sine,        Kind::cosine,     Kind::tangent,
                                   Kind::arc_tangent, Kind::arc_sine,    Kind::arc_cosine, Kind::exponential,
                                   Kind::logarithm,   Kind::square_root, Kind::absolute,   Kind::power,
                                   Kind::sum,         Kind::difference,  Kind::product,    Kind::quotient};
        const Kind kind = kinds[static_cast<std::size_t>(random_.number(0.0, 15.99))];
        std::vector<FormulaStep> steps = formula(depth - 1);
        if (operands_of(kind) == 2) {
            const std::vector<FormulaStep> other = formula(depth - 1);
            steps.insert(steps.end(), other.begin(), other.end());
        }
        steps.push_back({kind, kind == Kind::power ? exponent() : 0.0});
        return steps;
    }

private:
    std::vector<FormulaStep> leaf() {
        if (random_.number() < 0.2) { return {{Kind::variable, 0.0}}; }
        return {{Kind::number, random_.number(-2.0, 2.0)}};
    }
    double exponent() {
        constexpr std::array exponents{2.0, 3.0, -1.0, -2.0, 1.9, 0.0, 7.0, -0.5};
        return exponents[static_cast<std::size_t>(random_.number(0.0, 7.99))];
    }

    test::Random random_;
};

/// Values of the steps by the standard library.
Function function_of(const std::vector<FormulaStep>& steps) {
    return [&steps](Real t) { return test::formula_value(steps, t); };
}

/// First four Taylor coefficients by central differences of order h⁴, the last one of order h².
std::array<Real, 4> differences(const Function& f, Real t) {
    constexpr Real h = 1e-3L;
    const auto at = [&](int k) { return f(t + k * h); };
    const Real first = (8.0L * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0L * h);
    const Real second = (16.0L * (at(1) + at(-1)) - (at(2) + at(-2)) - 30.0L * at(0)) / (12.0L * h * h);
    const Real third = ((at(2) - at(-2)) - 2.0L * (at(1) - at(-1))) / (2.0L * h * h * h);
    return {f(t), first, second / 2.0L, third / 6.0L};
}

/// True if the function has moderate values around t, where the differences evaluate it.
bool is_calm(const Function& f, Real t) {
    for (int k = -40; k <= 40; ++k) {
        const auto around = differences(f, t + 0.001L * k);
        for (const Real x : around) {
            if (!(std::abs(x) < 100.0L)) { return false; }
        }
    }
    return true;
}

TimeFormula formula(std::vector<FormulaStep> steps) { return {{"", std::move(steps)}, 1.0}; }

/// exp(-((t - middle) / width)²)
TimeFormula pulse(double middle, double width) {
    return formula(
        {{Kind::variable},
         {Kind::number, middle},
         {Kind::difference},
         {Kind::number, width},
         {Kind::quotient},
         {Kind::power, 2.0},
         {Kind::negative},
         {Kind::exponential}});
}

}  // namespace

TEST_CASE("Formulas of time have the derivatives that differences of them have", "[core][time_formula]") {
    int looked_at = 0;
    for (unsigned seed = 1; seed <= 6000; ++seed) {
        const std::vector<FormulaStep> steps = Author(seed).formula(1 + static_cast<int>(seed % 5));
        const double t = test::Random(seed).number(-1.5, 1.5);
        if (!is_calm(function_of(steps), t)) { continue; }
        ++looked_at;
        CAPTURE(seed, t);
        const std::array<double, 3> found = formula(steps).taylor_at(t);
        if (!std::isfinite(found[1])) {
            // a power of 0 that stays 0: no lesson may have it
            CHECK(formula(steps).gap_between(t - 1e-6, t + 1e-6));
            --looked_at;
            continue;
        }
        const auto expected = differences(function_of(steps), t);
        // calm functions have fifth derivatives below 1e6: h⁴ of them is 1e-6
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(found[k] == Approx(static_cast<double>(expected[k])).epsilon(1e-5).margin(1e-5));
        }
        // a root of 0, or an arccos of 1, up to rounding has half of the digits
        CHECK(found[0] == Approx(static_cast<double>(expected[0])).epsilon(5e-8).margin(5e-8));
    }
    CHECK(looked_at > 2000);
}

TEST_CASE("Bounds of a formula hold all that lies between two times", "[core][time_formula]") {
    int bounded = 0;
    for (unsigned seed = 1; seed <= 4000; ++seed) {
        const std::vector<FormulaStep> steps = Author(seed).formula(1 + static_cast<int>(seed % 5));
        test::Random random(seed);
        const double from = random.number(-1.5, 1.5);
        const double to = from + random.number(0.0, 0.3);
        CAPTURE(seed, from, to);
        const std::array<double, 5> bounds = formula(steps).taylor_bounds(from, to);
        if (!std::ranges::all_of(bounds, [](double x) { return std::isfinite(x); })) { continue; }
        ++bounded;
        CHECK(bounds == formula(steps).taylor_bounds(to, from));
        for (int n = 1; n < 10; ++n) {
            const double t = from + (to - from) * n / 10.0;
            // what is bounded has a value beside t, too
            if (!is_calm(function_of(steps), t)) { continue; }
            const auto expected = differences(function_of(steps), t);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                CHECK(std::abs(static_cast<double>(expected[k])) <= bounds[k] * (1.0 + 1e-5) + 1e-4);
            }
        }
    }
    CHECK(bounded > 2000);
}

TEST_CASE("Bounds of a formula are narrow where it is looked at closely", "[core][time_formula]") {
    // 3 sin(2 t): the k-th coefficient is 3 2^k / k! times a sine or a cosine
    const TimeFormula swing = formula(
        {{Kind::number, 3.0},
         {Kind::number, 2.0},
         {Kind::variable},
         {Kind::product},
         {Kind::sine},
         {Kind::product}});
    const std::array<double, 5> near = swing.taylor_bounds(0.3, 0.3 + 1e-9);
    CHECK(near[0] == Approx(3.0 * std::sin(0.6)));
    CHECK(near[1] == Approx(6.0 * std::cos(0.6)));
    CHECK(near[2] == Approx(6.0 * std::sin(0.6)));
    CHECK(near[3] == Approx(4.0 * std::cos(0.6)));
    CHECK(near[4] == Approx(2.0 * std::sin(0.6)));
    // over whole turns they are the amplitudes
    const std::array<double, 5> far = swing.taylor_bounds(0.0, 10.0);
    CHECK(far[0] == Approx(3.0));
    CHECK(far[4] == Approx(2.0));
}

TEST_CASE("A time without value, rate or acceleration is found, however narrow", "[core][time_formula]") {
    const auto minus = [](double x, std::vector<FormulaStep> after) {
        std::vector<FormulaStep> steps{{Kind::variable}, {Kind::number, x}, {Kind::difference}};
        steps.insert(steps.end(), after.begin(), after.end());
        return formula(steps);
    };
    const double third = 1.0 / 3.0;
    for (const TimeFormula& f :
         {minus(third, {{Kind::power, -1.0}}), minus(third, {{Kind::power, 2.0}, {Kind::square_root}}),
          minus(third, {{Kind::absolute}}), minus(third, {{Kind::power, 2.0}, {Kind::logarithm}}),
          minus(third - 1.0, {{Kind::arc_sine}}), minus(third, {{Kind::power, 2.0}, {Kind::power, 0.9}})}) {
        const std::optional<double> gap = f.gap_between(0.0, third + 0.1);
        REQUIRE(gap);
        CHECK(*gap == Approx(third).margin(1e-6));
        CHECK_FALSE(f.gap_between(0.0, third - 1e-3));
        // at the end, too
        CHECK(f.gap_between(0.0, third));
    }
    CHECK_FALSE(pulse(0.5, 1e-3).gap_between(0.0, 1.0));
    // a pole beside the interval, and one that lies 1e-3 off the real axis
    CHECK_FALSE(minus(-1e-3, {{Kind::power, -1.0}}).gap_between(0.0, 1.0));
    CHECK_FALSE(minus(third, {{Kind::power, 2.0}, {Kind::number, 1e-6}, {Kind::sum}, {Kind::power, -1.0}})
                    .gap_between(0.0, 1.0));
}

TEST_CASE("Times are close where a formula swings, and only there", "[core][time_formula]") {
    std::vector<double> times;
    pulse(5.0, 0.01).append_swings(0.0, 10.0, times);
    CHECK(std::ranges::is_sorted(times));
    CHECK(times.back() == 10.0);
    CHECK(times.size() < 100);
    CHECK(std::ranges::count_if(times, [](double t) { return std::abs(t - 5.0) < 0.02; }) > 5);
    times.clear();
    // a cubic has no swing
    formula({{Kind::variable}, {Kind::power, 3.0}}).append_swings(0.0, 10.0, times);
    CHECK(times == std::vector<double>{10.0});
    times.clear();
    // sin(7 t): at most half a period apart
    formula({{Kind::number, 7.0}, {Kind::variable}, {Kind::product}, {Kind::sine}})
        .append_swings(0.0, 10.0, times);
    double before = 0.0;
    for (const double t : times) {
        CHECK(t - before <= 3.1416 / 7.0);
        before = t;
    }
}

TEST_CASE("A formula that does not change has no swings, whatever it is written as", "[core][time_formula]") {
    const std::vector<std::vector<FormulaStep>> constants{
        {{Kind::number, 3.0}},
        {{Kind::number, 0.0}},
        {{Kind::variable}, {Kind::variable}, {Kind::difference}},
        {{Kind::number, 0.0}, {Kind::variable}, {Kind::exponential}, {Kind::product}},
        {{Kind::variable},
         {Kind::sine},
         {Kind::power, 2.0},
         {Kind::variable},
         {Kind::cosine},
         {Kind::power, 2.0},
         {Kind::sum}}};
    for (const auto& steps : constants) {
        std::vector<double> times;
        formula(steps).append_swings(0.0, 1.0, times);
        CHECK(times.size() < 40);
    }
}

TEST_CASE("The integral of a law is that of its closed form, or none across a pole", "[core][time_formula]") {
    // 1 / (0.2 - x)
    const ScalarFormula pole{
        "", {{Kind::number, 0.2}, {Kind::variable}, {Kind::difference}, {Kind::power, -1.0}}};
    CHECK(pole.integral(-0.5, 0.1) == Approx(std::log(7.0)).epsilon(1e-11));
    CHECK(pole.integral(0.1, -0.5) == Approx(-std::log(7.0)).epsilon(1e-11));
    CHECK(std::isnan(pole.integral(0.5, 0.0)));
    // 100 exp(-10⁶ (x + 0.5)²), narrower than samples are apart
    const ScalarFormula peak{
        "",
        {{Kind::number, 100.0},
         {Kind::variable},
         {Kind::number, 0.5},
         {Kind::sum},
         {Kind::power, 2.0},
         {Kind::number, -1e6},
         {Kind::product},
         {Kind::exponential},
         {Kind::product}}};
    CHECK(peak.integral(-1.234, 0.0) == Approx(0.1 * std::sqrt(std::numbers::pi)).epsilon(1e-9));
    // |x|: a kink
    const ScalarFormula kink{"", {{Kind::variable}, {Kind::absolute}}};
    CHECK(kink.integral(-1.0, 2.0) == Approx(2.5).epsilon(1e-11));
    CHECK(kink.is_smooth_at(0.1));
    CHECK_FALSE(kink.is_smooth_at(1e-12));
    CHECK(kink.size_at(std::array{-2.0}) == 2.0);
}

}  // namespace jw
