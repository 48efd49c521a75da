#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <catch2/catch.hpp>

#include "lessons/formula/evaluate_formula.hpp"
#include "lessons/formula/steps_of_formula.hpp"

/// Formulas that are generated with their values: the text is read, the value is computed beside it.
namespace jw::formula::test {

namespace {

constexpr int kFormulas = 4000;
// numbers below 1e4 and some ten operations: a larger difference is not rounding
constexpr double kSame = 1e-11;

/// A number with its first and second rate: derivatives by rules that know nothing of the evaluator's.
struct Dual {
    double value = 0.0;
    double rate = 0.0;
    double bend = 0.0;
};
Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.rate + b.rate, a.bend + b.bend}; }
Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.rate - b.rate, a.bend - b.bend}; }
Dual operator*(Dual a, Dual b) {
    return {
        a.value * b.value, a.rate * b.value + a.value * b.rate,
        a.bend * b.value + 2.0 * a.rate * b.rate + a.value * b.bend};
}
/// f(a), whose derivatives by a are given.
Dual chain(Dual a, double f, double first, double second) {
    return {f, first * a.rate, second * a.rate * a.rate + first * a.bend};
}
Dual operator/(Dual a, Dual b) {
    const double x = 1.0 / b.value;
    return a * chain(b, x, -x * x, 2.0 * x * x * x);
}

constexpr Dual kX{1.3, 0.4, -0.6};
constexpr Dual kTheta{0.7, -1.1, 0.8};

struct Formula {
    std::string text;
    Dual is;
    bool is_sum = false;  ///< needs parentheses beside a factor
};

class Author {
public:
    explicit Author(unsigned seed) : random_(seed) {}

    Formula formula(int depth) {
        if (depth == 0) { return leaf(); }
        switch (below(8)) {
            case 0: return sum(formula(depth - 1), formula(depth - 1));
            case 1: return product(formula(depth - 1), formula(depth - 1));
            case 2: return fraction(formula(depth - 1), formula(depth - 1));
            case 3: return raised(formula(depth - 1));
            case 4: return root(formula(depth - 1));
            case 5: return trigonometric(formula(depth - 1));
            case 6: return multiple_angle();
            default: return size(formula(depth - 1));
        }
    }

private:
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

    static std::string factor(const Formula& f) { return f.is_sum ? "(" + f.text + ")" : f.text; }

    Formula leaf() {
        switch (below(4)) {
            case 0: return {"2", {2.0}};
            case 1: return {"0.75", {0.75}};
            case 2: return {"x", kX};
            default: return {"\\theta", kTheta};
        }
    }
    Formula sum(const Formula& a, const Formula& b) {
        if (below(2) == 0) { return {a.text + " + " + b.text, a.is + b.is, true}; }
        return {a.text + " - " + factor(b), a.is - b.is, true};
    }
    /// Written side by side, in parentheses: a function or a digit would take in what follows.
    Formula product(const Formula& a, const Formula& b) {
        return {"(" + a.text + ") (" + b.text + ")", a.is * b.is};
    }
    Formula fraction(const Formula& a, const Formula& b) {
        if (std::abs(b.is.value) < 0.1) { return a; }
        return {"\\frac{" + a.text + "}{" + b.text + "}", a.is / b.is};
    }
    Formula raised(const Formula& a) {
        struct Exponent {
            const char* text;
            double value;
        };
        constexpr Exponent exponents[] = {
            {"2", 2.0},   {"3", 3.0},   {"-1", -1.0},          {"-2", -2.0},
            {"0.5", 0.5}, {"1.9", 1.9}, {"\\frac{1}{2}", 0.5}, {"-\\frac{3}{2}", -1.5},
            {"2-1", 1.0}, {"0", 0.0},   {"2 \\cdot 2", 4.0}};
        const auto& [text, n] = exponents[below(std::size(exponents))];
        const bool whole = n == std::floor(n);
        if (std::abs(a.is.value) > 20.0 || std::abs(a.is.value) < 0.1 || (a.is.value < 0.0 && !whole)) {
            return a;
        }
        const double x = a.is.value;
        const double slope = n == 0.0 ? 0.0 : n * std::pow(x, n - 1.0);
        const double bend = n * (n - 1.0) == 0.0 ? 0.0 : n * (n - 1.0) * std::pow(x, n - 2.0);
        return {"(" + a.text + ")^{" + text + "}", chain(a.is, std::pow(x, n), slope, bend)};
    }
    Formula root(const Formula& a) {
        if (a.is.value < 0.1) { return a; }
        const double r = std::sqrt(a.is.value);
        return {"\\sqrt{" + a.text + "}", chain(a.is, r, 0.5 / r, -0.25 / (r * r * r))};
    }
    Formula trigonometric(const Formula& a) {
        const double x = a.is.value;
        const double s = std::sin(x);
        const double c = std::cos(x);
        switch (below(8)) {
            case 4: {
                if (std::abs(x) > 4.0) { return a; }
                return {"\\exp(" + a.text + ")", chain(a.is, std::exp(x), std::exp(x), std::exp(x))};
            }
            case 5: {
                if (x < 0.1) { return a; }
                return {"\\ln(" + a.text + ")", chain(a.is, std::log(x), 1.0 / x, -1.0 / (x * x))};
            }
            case 6: {
                if (std::abs(x) > 0.9) { return a; }
                const double q = 1.0 - x * x;
                return {
                    "\\arcsin(" + a.text + ")",
                    chain(a.is, std::asin(x), 1.0 / std::sqrt(q), x / (q * std::sqrt(q)))};
            }
            case 0: return {"\\sin(" + a.text + ")", chain(a.is, s, c, -s)};
            case 1:
                return {"\\cos^2(" + a.text + ")", chain(a.is, c * c, -2.0 * c * s, 2.0 * (s * s - c * c))};
            case 2: {
                const double q = 1.0 / (1.0 + x * x);
                return {"\\arctan(" + a.text + ")", chain(a.is, std::atan(x), q, -2.0 * x * q * q)};
            }
            case 3: {
                if (std::abs(x) > 0.9) { return a; }
                const double q = 1.0 - x * x;
                return {
                    "\\arccos(" + a.text + ")",
                    chain(a.is, std::acos(x), -1.0 / std::sqrt(q), -x / (q * std::sqrt(q)))};
            }
            default: {
                if (std::abs(c) < 0.1) { return a; }
                return {"\\tan(" + a.text + ")", chain(a.is, s / c, 1.0 / (c * c), 2.0 * s / (c * c * c))};
            }
        }
    }
    /// As in textbooks: \sin 2\theta, and what follows a function is no part of its argument.
    Formula multiple_angle() {
        const auto sine_of = [](Dual a) {
            return chain(a, std::sin(a.value), std::cos(a.value), -std::sin(a.value));
        };
        const auto cosine_of = [](Dual a) {
            return chain(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
        };
        switch (below(4)) {
            case 0: return {"\\sin 2\\theta", sine_of(Dual{2.0} * kTheta)};
            case 1: return {"2 \\sin\\theta \\cos\\theta", sine_of(Dual{2.0} * kTheta)};
            case 2: return {"2 x \\cos\\frac{\\theta}{2} \\sin\\frac{1}{2}\\theta", kX * sine_of(kTheta)};
            default: return {"\\cos\\theta x", cosine_of(kTheta) * kX};
        }
    }
    Formula size(const Formula& a) { return {"|" + a.text + "|", a.is.value < 0.0 ? Dual{} - a.is : a.is}; }

    std::mt19937 random_;
};

Meanings meanings() {
    const auto value_of = [](const Dual& a) {
        const auto matrix = [](double x) -> MatrixX { return MatrixX::Constant(1, 1, x); };
        return moving(matrix(a.value), matrix(a.rate), matrix(a.bend), 2);
    };
    return {
        [=](const Symbol& symbol) -> std::optional<Value> {
            if (symbol == Symbol{"θ", 0, {}, {}}) { return value_of(kTheta); }
            if (symbol == Symbol{"x", 0, {}, {}}) { return value_of(kX); }
            // like the value in a pose that should be at x, and a small angle
            if (symbol == Symbol{"y", 0, {}, {}}) { return value_of({kX.value + 1e-12}); }
            if (symbol == Symbol{"φ", 0, {}, {}}) { return value_of({1e-8}); }
            return std::nullopt;
        },
        {}};
}

/// Difference of both sides, relative to its scale.
double part_of(const std::string& equation) {
    const Outcome outcome = evaluate_equation(math::own_math(equation), {}, meanings());
    INFO(equation);
    REQUIRE_FALSE(outcome.problem);
    return outcome.apart.difference / std::max(outcome.apart.scale, 1e-300);
}

std::string why_not(const std::string& equation) {
    const Outcome outcome = evaluate_equation(math::own_math(equation), {}, meanings());
    return outcome.problem ? outcome.problem->message : "it has a value";
}

/// Number in the notation of formulas, which has no exponents; for numbers above 1e-2.
std::string digits(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17f", x);
    return text;
}

}  // namespace

TEST_CASE("Generated formulas have the values and the rates that they were made with", "[formula]") {
    const Meanings known = meanings();
    const std::array variables{Variable{{"x", 0, {}, {}}, 0}, Variable{{"θ", 0, {}, {}}, 1}};
    for (unsigned seed = 0; seed < kFormulas; ++seed) {
        const Formula f = Author(seed).formula(1 + static_cast<int>(seed % 4));
        const auto small = [](double x) { return std::abs(x) < 1e4; };
        if (!small(f.is.value) || !small(f.is.rate) || !small(f.is.bend)) { continue; }
        CAPTURE(seed, f.text);
        const auto agrees = [&](const std::string& text, double expected, double digits_lost) {
            const Value found = evaluate_expression(math::own_math(text), known);
            const double apart = std::abs(found.d[0](0, 0) - expected);
            return apart <= digits_lost * kSame * std::max(1.0, std::abs(expected));
        };
        REQUIRE(agrees(f.text, f.is.value, 1.0));
        // as a formula of plain numbers, too
        const double found = scalar_formula(f.text, variables).at(std::array{kX.value, kTheta.value});
        REQUIRE(std::abs(found - f.is.value) <= kSame * std::max(1.0, std::abs(f.is.value)));
        // terms of derivatives cancel
        REQUIRE(agrees("\\frac{d}{dt}(" + f.text + ")", f.is.rate, 1e2));
        REQUIRE(agrees("\\frac{d^2}{dt^2}(" + f.text + ")", f.is.bend, 1e4));
        const Value value = evaluate_expression(math::own_math(f.text), known);
        // the equation holds, and with one digit in 10000 changed it does not
        if (std::abs(f.is.value) < 1e-2) { continue; }
        CHECK(part_of(f.text + " = " + digits(f.is.value)) < 1e-9);
        if (value.scale[0] < 10.0 * std::abs(f.is.value)) {
            CHECK(part_of(f.text + " = " + digits(1.0001 * f.is.value)) > 1e-9);
        }
    }
}

TEST_CASE("Identities of textbooks hold, and what only looks like them does not", "[formula]") {
    for (const char* const right :
         {R"(\sin 2\theta = 2 \sin\theta \cos\theta)", R"(\sin^2\theta = \frac{1}{2} (1 - \cos 2\theta))",
          R"(\theta^{\frac{1}{2}} = \sqrt{\theta})", R"(\theta^{0.5} \theta^{0.5} = \theta)",
          R"(2^{1.9} 2^{0.1} = 4)", R"(\cos 0 = 1)", R"(\sqrt{0} = 0)", R"(|0| = 0)",
          R"(\operatorname{atan2}(0, 2) = 0)", R"(0^2 = 0)", R"(\sin \pi = 0)",
          R"(\frac{d}{dt} \theta x = \dot{\theta} x + \theta \dot{x})",
          R"(\frac{d}{dt} \theta^2 = 2 \theta \dot{\theta})", R"(\frac{d}{dt}(\theta) x = \dot{\theta} x)",
          R"(10^9 + 1 = 1000000001)", R"(10^9 + \theta - 10^9 = \theta)", R"(\arccos 1 = 0)",
          R"((1 + \phi) (x - y) = 0)"}) {
        CAPTURE(right);
        CHECK(part_of(right) < 1e-9);
    }
    for (const char* const wrong :
         {R"(\theta^{\frac{1}{2}} = \theta)", R"(\theta^{0.5} = 1)", R"(\theta^{2-1} = \theta^{-1})",
          R"(2^{1.9} = 2)", R"(10^9 + 1 = 10^9)", R"(10^9 + \theta = 10^9)",
          R"(\frac{d}{dt} \theta x = \dot{\theta} x)", R"(\sqrt{\theta - \theta} = 0.01)", R"(x^{2T} = x)"}) {
        CAPTURE(wrong);
        CHECK(part_of(wrong) > 1e-9);
    }
}

TEST_CASE("Sides that differ are told with the digits in which they differ, others with few", "[formula]") {
    const auto told = [](const std::string& equation) {
        const Outcome outcome = evaluate_equation(math::own_math(equation), {}, meanings());
        return outcome.left + " and " + outcome.right;
    };
    CHECK(told(R"(10^9 + 1 = 10^9)") == "1000000001 and 1000000000");
    CHECK(told(R"(1 = 2)") == "1 and 2");
    CHECK(told(R"(10^9 = 10^9)") == "1e+09 and 1e+09");
    // the entries that differ most
    CHECK(
        told(R"(\begin{bmatrix} 10^9 + 100 \\ 5 \end{bmatrix} = \begin{bmatrix} 10^9 \\ 6 \end{bmatrix})") ==
        "[1.0000001e+09, 5] and [1e+09, 6]");
    CHECK(told(R"(1 + 10^{-13} = 1)") == "1.0000000000001 and 1");
}

TEST_CASE("What can be read in two ways, or has no value, is refused with its reason", "[formula]") {
    CHECK_THAT(why_not(R"(\sin\theta / 2 = 1)"), Catch::Contains("two ways"));
    CHECK_THAT(why_not(R"(\sin^{-1} x = 1)"), Catch::Contains("two ways"));
    CHECK_THAT(why_not(R"(x^12 = 1)"), Catch::Contains("two ways"));
    CHECK_THAT(why_not(R"(\sin(x)^2 = 1)"), Catch::Contains("two ways"));
    CHECK_THAT(why_not(R"(x^{12} + x^1 2 = \sin^2(x))"), Catch::Contains("has a value"));
    CHECK_THAT(why_not(R"(2^x = 1)"), Catch::Contains("neither T nor a number"));
    CHECK_THAT(why_not(R"(\theta^{2 x} = 1)"), Catch::Contains("exponent"));
    CHECK_THAT(why_not(R"(\frac{d^3}{dt^3} x = 1)"), Catch::Contains("derivative is not known"));
    CHECK_THAT(why_not(R"(\frac{d^2}{dt} x = 1)"), Catch::Contains("derivative is not known"));
    CHECK_THAT(why_not(R"(\sqrt{-x} = 1)"), Catch::Contains("negative"));
    CHECK_THAT(why_not(R"((-x)^{0.5} = 1)"), Catch::Contains("negative"));
    CHECK_THAT(why_not(R"(\frac{1}{x - x} = 1)"), Catch::Contains("divided by zero"));
    CHECK_THAT(why_not(R"(0^{-1} = 1)"), Catch::Contains("divided by zero"));
    CHECK_THAT(why_not(R"(\arccos 2 = 1)"), Catch::Contains("not between -1 and 1"));
    CHECK_THAT(
        why_not(R"(\begin{bmatrix} 1 & 1 \\ 1 & 1 \end{bmatrix}^{-1} = I)"), Catch::Contains("singular"));
}

}  // namespace jw::formula::test
