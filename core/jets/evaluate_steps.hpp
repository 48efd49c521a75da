#pragma once

#include <array>
#include <span>

#include "core/jets/formula_steps.hpp"
#include "core/jets/taylor.hpp"

/// Evaluates formulas in Taylor coefficients of numbers or of intervals.
namespace jw::formula_steps {

/// The stack of a formula while it is evaluated.
template <class T>
class Stack {
public:
    void push(const T& value) { values_[size_++] = value; }
    T pop() { return values_[--size_]; }

private:
    std::array<T, ScalarFormula::kDeepest> values_;
    std::size_t size_ = 0;
};

template <class T>
T result_of(const FormulaStep& step, const T& a) {
    using Kind = FormulaStep::Kind;
    switch (step.kind) {
        case Kind::negative: return -a;
        case Kind::power: return taylor::power(a, step.number);
        case Kind::sine: return taylor::sine_and_cosine(a).first;
        case Kind::cosine: return taylor::sine_and_cosine(a).second;
        case Kind::tangent: {
            const auto [sine, cosine] = taylor::sine_and_cosine(a);
            return sine / cosine;
        }
        case Kind::arc_sine: return taylor::arc_sine(a);
        case Kind::arc_cosine: return taylor::arc_cosine(a);
        case Kind::arc_tangent: return taylor::arc_tangent(a);
        case Kind::exponential: return taylor::exponential(a);
        case Kind::logarithm: return taylor::logarithm(a);
        case Kind::absolute: return taylor::absolute(a);
        default: return taylor::square_root(a);
    }
}

template <class T>
T result_of(const FormulaStep& step, const T& a, const T& b) {
    using Kind = FormulaStep::Kind;
    switch (step.kind) {
        case Kind::sum: return a + b;
        case Kind::difference: return a - b;
        case Kind::product: return a * b;
        default: return a / b;
    }
}

/// @param variables  in the order of their indices
template <class T>
T evaluated(std::span<const FormulaStep> steps, std::span<const T> variables) {
    using Kind = FormulaStep::Kind;
    Stack<T> stack;
    for (const FormulaStep& step : steps) {
        switch (operands_of(step.kind)) {
            case 0:
                stack.push(
                    step.kind == Kind::variable ? variables[static_cast<std::size_t>(step.number)]
                                                : T::constant(step.number));
                break;
            case 1: stack.push(result_of(step, stack.pop())); break;
            default: {
                const T b = stack.pop();
                stack.push(result_of(step, stack.pop(), b));
            }
        }
    }
    return stack.pop();
}

}  // namespace jw::formula_steps
