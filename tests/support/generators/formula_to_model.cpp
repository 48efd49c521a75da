#include "tests/support/generators/formula_to_model.hpp"

#include <string>

#include "tests/support/vector_formulas.hpp"

namespace jw::test {

namespace general = reference::general;

namespace {

/// The part of the tree that the step before `next` ends; `next` comes to lie before its first step.
general::FormulaTree branch_of(const std::vector<FormulaStep>& steps, std::size_t& next) {
    static const std::vector<std::string> names{"number",   "variable", "+",   "-",   "*",    "/",
                                                "negative", "power",    "sin", "cos", "tan",  "arcsin",
                                                "arccos",   "arctan",   "exp", "ln",  "sqrt", "abs"};
    const FormulaStep& step = steps.at(--next);
    general::FormulaTree out{names.at(static_cast<std::size_t>(step.kind)), step.number, {}};
    for (int k = 0; k < operands_of(step.kind); ++k) {
        out.of.insert(out.of.begin(), branch_of(steps, next));
    }
    return out;
}

/// A vector in the frame of one of the bodies of a joint.
general::Fixed fixed_in(int body, const Vec3& local) { return {body, local.cast<long double>()}; }

/// Vectors of a formula, in the order of FormulaVector.
std::vector<general::OfVectors::Vector> vectors_of(const Joint& joint) {
    using Kind = general::OfVectors::Vector::Kind;
    const JointGeometry& g = joint.geometry;
    const auto in_i = [&](const Vec3& local) { return fixed_in(joint.body_i, local); };
    const auto in_j = [&](const Vec3& local) { return fixed_in(joint.body_j, local); };
    std::vector<general::OfVectors::Vector> all{
        {Kind::direction, in_i(g.s_i_local)},
        {Kind::direction, in_j(g.s_j_local)},
        {Kind::direction, in_i(g.u_i_local)},
        {Kind::direction, in_j(g.u_j_local)},
        {Kind::way, in_j(g.P_j_local), in_i(g.P_i_local)},
        {Kind::point, in_i(g.O_i_local)},
        {Kind::point, in_j(g.O_j_local)},
        {Kind::point, in_i(g.P_i_local)},
        {Kind::point, in_j(g.P_j_local)}};
    for (Eigen::Index k = 0; k < 3; ++k) { all.push_back({Kind::direction, in_i(Vec3::Unit(k))}); }
    for (Eigen::Index k = 0; k < 3; ++k) { all.push_back({Kind::direction, in_j(Vec3::Unit(k))}); }
    return all;
}

}  // namespace

general::FormulaTree tree_of(const std::vector<FormulaStep>& steps) {
    std::size_t next = steps.size();
    return branch_of(steps, next);
}

general::Equation equation_of_formula(const Joint& joint, int of) {
    using enum FormulaVector;
    const JointGeometry& g = joint.geometry;
    const std::vector<FormulaStep>& steps = g.formula.steps;
    const bool has_right = steps.size() > 1 && steps.back().kind == FormulaStep::Kind::difference &&
                           steps.end()[-2].kind == FormulaStep::Kind::number;
    const double right = has_right ? steps.end()[-2].number : 0.0;
    const auto says = [&](const authored::Part& left) {
        return steps == authored::equation(left, right).steps;
    };
    const general::Fixed axis_i = fixed_in(joint.body_i, g.s_i_local);
    const general::Fixed from = fixed_in(joint.body_i, g.P_i_local);
    const general::Fixed to = fixed_in(joint.body_j, g.P_j_local);
    general::Equation equation;
    equation.of = of;
    equation.constant = right;
    if (says(authored::dot(s_i, s_j))) {
        equation.measure = general::Product{axis_i, fixed_in(joint.body_j, g.s_j_local)};
    } else if (says(authored::dot(s_i, d))) {
        equation.measure = general::Along{axis_i, from, to};
    } else if (says(authored::dot(d, d))) {
        equation.measure = general::SquaredDistance{from, to};
    } else {
        equation.measure = general::OfVectors{tree_of(steps), vectors_of(joint)};
        equation.constant = 0.0L;
    }
    return equation;
}

}  // namespace jw::test
