#include "core/jets/formula_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/jets/evaluate_steps.hpp"

namespace jw {

int operands_of(FormulaStep::Kind kind) {
    using Kind = FormulaStep::Kind;
    switch (kind) {
        case Kind::number:
        case Kind::variable: return 0;
        case Kind::sum:
        case Kind::difference:
        case Kind::product:
        case Kind::quotient: return 2;
        default: return 1;
    }
}

namespace {

constexpr std::size_t kMostVariables = 2;
// of x: poses are known to less
constexpr double kBeside = 1e-9;
// of an integral; a kink is found to 2^-40 of the way
constexpr double kAccuracy = 1e-12;
constexpr int kDeepestHalving = 40;

template <class T>
using Variables = std::array<T, kMostVariables>;

template <class S, std::size_t N>
Taylor<S, N> at_rest(const ScalarFormula& formula, const Taylor<S, N>& x, const Taylor<S, N>& rate = {}) {
    const Variables<Taylor<S, N>> variables{x, rate};
    return formula_steps::evaluated<Taylor<S, N>>(formula.steps, variables);
}

double value_at(const ScalarFormula& formula, double x) {
    return at_rest(formula, Taylor<double, 1>::constant(x)).c[0];
}

/// Size of the terms of a result, from its value and those of its operands.
double size_of(const FormulaStep& step, double value, double a, double size_a, double size_b) {
    using Kind = FormulaStep::Kind;
    switch (step.kind) {
        case Kind::sum:
        case Kind::difference: return size_a + size_b;
        case Kind::product: return size_a * size_b;
        case Kind::negative:
        case Kind::absolute: return size_a;
        case Kind::sine:
        case Kind::cosine:
        case Kind::arc_tangent: return std::abs(value) + size_a;
        default: break;
    }
    // the same share of the value as of the operand
    return a != 0.0 ? std::abs(value) * std::max(1.0, size_a / std::abs(a)) : std::abs(value);
}

/// Simpson's rule, on parts in which the fourth derivative bounds its error by h^5 / 2880 times that.
double integral_of(const ScalarFormula& formula, double from, double to, double most, int depth) {
    const auto over = at_rest(formula, Taylor<Interval, 5>::variable({from, to}));
    const double h = to - from;
    const double middle = 0.5 * (from + to);
    const bool is_accurate = over.c[4].magnitude() * 24.0 / 2880.0 * h * h * h * h * h <= most;
    if (is_accurate || depth == 0) {
        if (!over.c[0].is_bounded()) { return std::numeric_limits<double>::quiet_NaN(); }
        return h / 6.0 * (value_at(formula, from) + 4.0 * value_at(formula, middle) + value_at(formula, to));
    }
    return integral_of(formula, from, middle, 0.5 * most, depth - 1) +
           integral_of(formula, middle, to, 0.5 * most, depth - 1);
}

}  // namespace

double ScalarFormula::at(std::span<const double> variables) const {
    using Number = Taylor<double, 1>;
    Variables<Number> numbers;
    for (std::size_t k = 0; k < variables.size(); ++k) { numbers[k] = Number::constant(variables[k]); }
    return formula_steps::evaluated<Number>(steps, numbers).c[0];
}

double ScalarFormula::size_at(std::span<const double> variables) const {
    std::vector<double> values;
    std::vector<double> sizes;
    for (const FormulaStep& step : steps) {
        const int operands = operands_of(step.kind);
        if (operands == 0) {
            const bool is_number = step.kind == FormulaStep::Kind::number;
            values.push_back(is_number ? step.number : variables[static_cast<std::size_t>(step.number)]);
            sizes.push_back(std::abs(values.back()));
            continue;
        }
        const auto take = [](std::vector<double>& from) {
            const double last = from.back();
            from.pop_back();
            return last;
        };
        const double b = operands == 2 ? take(values) : 0.0;
        const double size_b = operands == 2 ? take(sizes) : 0.0;
        const double a = take(values);
        using Number = Taylor<double, 1>;
        const Number result = operands == 2
                                  ? formula_steps::result_of(step, Number::constant(a), Number::constant(b))
                                  : formula_steps::result_of(step, Number::constant(a));
        values.push_back(result.c[0]);
        sizes.push_back(size_of(step, values.back(), a, take(sizes), size_b));
    }
    return sizes.back();
}

bool ScalarFormula::uses(int variable) const {
    return std::ranges::any_of(steps, [&](const FormulaStep& step) {
        return step.kind == FormulaStep::Kind::variable && step.number == variable;
    });
}

ScalarFormula::Slopes ScalarFormula::slopes_at(double x) const {
    using T = Taylor<double, 2>;
    const auto [value, by_x] = at_rest(*this, T::variable(x)).c;
    return {value, by_x, at_rest(*this, T::constant(x), T::variable(0.0)).c[1]};
}

bool ScalarFormula::is_smooth_at(double x) const {
    using T = Taylor<Interval, 2>;
    const double beside = kBeside * std::max(1.0, std::abs(x));
    return at_rest(*this, T::variable({x - beside, x + beside})).c[1].is_bounded();
}

double ScalarFormula::integral(double from, double to) const {
    if (from == to) { return 0.0; }
    if (from > to) { return -integral(to, from); }
    const double size = size_at(std::array{from, 0.0}) + size_at(std::array{to, 0.0});
    const double most = kAccuracy * std::max(size, std::numeric_limits<double>::min()) * (to - from);
    return integral_of(*this, from, to, most, kDeepestHalving);
}

}  // namespace jw
