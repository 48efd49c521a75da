#pragma once

#include <cmath>
#include <initializer_list>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/model/joint_types.hpp"

namespace jw::test {

/// Value of a formula in long double, by functions of the standard library.
/// @param variables  in the order of their indices
inline long double formula_value(
    const std::vector<FormulaStep>& steps, std::span<const long double> variables) {
    using Kind = FormulaStep::Kind;
    std::vector<long double> stack;
    for (const FormulaStep& step : steps) {
        if (operands_of(step.kind) == 0) {
            stack.push_back(
                step.kind == Kind::variable ? variables[static_cast<std::size_t>(step.number)] : step.number);
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

/// Value of a formula of one variable.
inline long double formula_value(const std::vector<FormulaStep>& steps, long double t) {
    return formula_value(steps, std::span<const long double>(&t, 1));
}

/// Variables of the formula of a joint between two poses: the components of s_i, s_j, u_i, u_j, d, r_i, r_j,
/// r_i^P, r_j^P and of the columns of A_i and A_j, all global.
inline std::vector<long double> formula_variables(
    const JointGeometry& g, const Eigen::Matrix<long double, 3, 1>& r_i,
    const Eigen::Matrix<long double, 3, 3>& A_i, const Eigen::Matrix<long double, 3, 1>& r_j,
    const Eigen::Matrix<long double, 3, 3>& A_j) {
    using V3 = Eigen::Matrix<long double, 3, 1>;
    std::vector<long double> all;
    const auto add = [&](const V3& v) { all.insert(all.end(), {v.x(), v.y(), v.z()}); };
    const auto turned = [](const Eigen::Matrix<long double, 3, 3>& A, const Vec3& local) {
        return V3(A * local.cast<long double>());
    };
    const V3 P_i = r_i + turned(A_i, g.P_i_local);
    const V3 P_j = r_j + turned(A_j, g.P_j_local);
    add(turned(A_i, g.s_i_local));
    add(turned(A_j, g.s_j_local));
    add(turned(A_i, g.u_i_local));
    add(turned(A_j, g.u_j_local));
    const V3 O_i = r_i + turned(A_i, g.O_i_local);
    const V3 O_j = r_j + turned(A_j, g.O_j_local);
    for (const V3& v : {V3(P_j - P_i), O_i, O_j, P_i, P_j}) { add(v); }
    for (int k = 0; k < 3; ++k) { add(A_i.col(k)); }
    for (int k = 0; k < 3; ++k) { add(A_j.col(k)); }
    return all;
}

}  // namespace jw::test
