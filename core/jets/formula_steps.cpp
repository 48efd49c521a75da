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

// relative error of an integral; a kink is located to 2^-40 of the range
constexpr double kAccuracy = 1e-12;
constexpr int kDeepestHalving = 40;
// some milliseconds; a law that needs more is taken to have no integral
constexpr int kMostPieces = 20000;

template <class T>
using Variables = std::array<T, ScalarFormula::kMostVariables>;

template <class S, std::size_t N>
Taylor<S, N> at_rest(const ScalarFormula& formula, const Taylor<S, N>& x) {
    const Variables<Taylor<S, N>> variables{x};
    return formula_steps::evaluated<Taylor<S, N>>(formula.steps, variables);
}

double value_at(const ScalarFormula& formula, double x) {
    return at_rest(formula, Taylor<double, 1>::constant(x)).c[0];
}

/// Size of the terms of a result, from its value, its first operand and the sizes of the operands.
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
    const double slope = formula_steps::result_of(step, Taylor<double, 2>::variable(a)).c[1];
    return std::max(std::abs(value), std::abs(slope) * size_a);
}

/// Simpson's rule on parts of length h: its error is at most h^5 / 2880 times the fourth derivative.
class Quadrature {
public:
    /// @param most  largest error of the integral per unit of x
    Quadrature(const ScalarFormula& formula, double most) : formula_(&formula), most_(most) {}

    double over(double from, double to, int depth) {
        const auto bounds = at_rest(*formula_, Taylor<Interval, 5>::variable({from, to}));
        const double h = to - from;
        const double middle = 0.5 * (from + to);
        const bool is_accurate = bounds.c[4].magnitude() * 24.0 / 2880.0 * h * h * h * h <= most_;
        if (--parts_left_ < 0 || (depth == 0 && !bounds.c[0].is_bounded())) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (is_accurate || depth == 0) {
            return h / 6.0 *
                   (value_at(*formula_, from) + 4.0 * value_at(*formula_, middle) + value_at(*formula_, to));
        }
        const double left = over(from, middle, depth - 1);
        return parts_left_ < 0 ? left : left + over(middle, to, depth - 1);
    }

private:
    const ScalarFormula* formula_;
    double most_;
    int parts_left_ = kMostPieces;
};

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
        const double size_a = take(sizes);
        sizes.push_back(
            step.kind == FormulaStep::Kind::quotient
                ? std::max(size_a, std::abs(values.back()) * size_b) / std::abs(b)
                : size_of(step, values.back(), a, size_a, size_b));
    }
    return sizes.back();
}

bool ScalarFormula::uses_any(int first, int last) const {
    return std::ranges::any_of(steps, [&](const FormulaStep& step) {
        return step.kind == FormulaStep::Kind::variable && step.number >= first && step.number < last;
    });
}

ScalarFormula ScalarFormula::along(std::span<const double> variables, std::size_t k) const {
    using Kind = FormulaStep::Kind;
    ScalarFormula out = *this;
    for (FormulaStep& step : out.steps) {
        if (step.kind != Kind::variable) { continue; }
        const auto index = static_cast<std::size_t>(step.number);
        step = index == k ? FormulaStep{Kind::variable, 0.0} : FormulaStep{Kind::number, variables[index]};
    }
    return out;
}

double ScalarFormula::slope_at(double x) const { return at_rest(*this, Taylor<double, 2>::variable(x)).c[1]; }

bool ScalarFormula::is_smooth_at(double x, double beside) const {
    using T = Taylor<Interval, 2>;
    const double most = beside * std::max(1.0, std::abs(x));
    return at_rest(*this, T::variable({x - most, x + most})).c[1].is_bounded();
}

double ScalarFormula::integral(double from, double to) const {
    if (from == to) { return 0.0; }
    if (from > to) { return -integral(to, from); }
    const double largest = at_rest(*this, Taylor<Interval, 1>::variable({from, to})).c[0].magnitude();
    const double at_ends = size_at(std::array{from, 0.0}) + size_at(std::array{to, 0.0});
    const double size = std::isfinite(largest) ? largest : at_ends;
    return Quadrature(*this, kAccuracy * size).over(from, to, kDeepestHalving);
}

}  // namespace jw
