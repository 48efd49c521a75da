#pragma once

#include <cmath>
#include <vector>

#include "core/jets/formula_steps.hpp"

namespace jw::test {

/// Value of a formula of one variable in long double, by functions of the standard library.
inline long double formula_value(const std::vector<FormulaStep>& steps, long double t) {
    using Kind = FormulaStep::Kind;
    std::vector<long double> stack;
    for (const FormulaStep& step : steps) {
        if (operands_of(step.kind) == 0) {
            stack.push_back(step.kind == Kind::variable ? t : step.number);
            continue;
        }
        const long double y = stack.back();
        if (operands_of(step.kind) == 2) { stack.pop_back(); }
        long double& x = stack.back();
        switch (step.kind) {
            case Kind::number:
            case Kind::variable: break;
            case Kind::sum: x += y; break;
            case Kind::difference: x -= y; break;
            case Kind::product: x *= y; break;
            case Kind::quotient: x /= y; break;
            case Kind::negative: x = -x; break;
            case Kind::power: x = std::pow(x, static_cast<long double>(step.number)); break;
            case Kind::sine: x = std::sin(x); break;
            case Kind::cosine: x = std::cos(x); break;
            case Kind::tangent: x = std::tan(x); break;
            case Kind::arc_sine: x = std::asin(x); break;
            case Kind::arc_cosine: x = std::acos(x); break;
            case Kind::arc_tangent: x = std::atan(x); break;
            case Kind::exponential: x = std::exp(x); break;
            case Kind::logarithm: x = std::log(x); break;
            case Kind::square_root: x = std::sqrt(x); break;
            case Kind::absolute: x = std::abs(x); break;
        }
    }
    return stack.back();
}

}  // namespace jw::test
