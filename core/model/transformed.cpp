#include "core/model/transformed.hpp"

namespace jw {

Mechanism moved_rigidly(Mechanism mechanism, const Vec4& p, const Vec3& r) {
    const Mat3 A = rotation_matrix(p);
    for (Body& body : mechanism.bodies) {
        body.r = r + A * body.r;
        body.p = product(p, body.p);
        body.r_dot = A * body.r_dot;
    }
    return mechanism;
}

namespace {

/// Formula that is evaluated with the lengths of the mechanism before it was scaled.
ScalarFormula unscaled(ScalarFormula formula, double factor) {
    constexpr int first = variable_of(FormulaVector::d, 0);
    constexpr int last = variable_of(FormulaVector::r_j_P, 2);
    std::vector<FormulaStep> steps;
    for (const FormulaStep& step : formula.steps) {
        steps.push_back(step);
        if (step.kind != FormulaStep::Kind::variable || step.number < first || step.number > last) {
            continue;
        }
        steps.push_back({FormulaStep::Kind::number, factor});
        steps.push_back({FormulaStep::Kind::quotient, 0.0});
    }
    formula.steps = std::move(steps);
    return formula;
}

}  // namespace

Mechanism scaled(Mechanism mechanism, double factor) {
    for (Body& body : mechanism.bodies) {
        body.r *= factor;
        body.r_dot *= factor;
    }
    for (Joint& joint : mechanism.joints) {
        JointGeometry& g = joint.geometry;
        for (double* length : {&g.length, &g.alpha, &g.d_0, &g.radii[0], &g.radii[1]}) { *length *= factor; }
        if (g.displacement_dot_start) { *g.displacement_dot_start *= factor; }
        g.curve.constant *= factor;
        g.curve.linear *= factor;
        for (Curve::Harmonic& h : g.curve.harmonics) { h = {factor * h.cos, factor * h.sin}; }
        g.P_i_local *= factor;
        g.P_j_local *= factor;
        g.O_i_local *= factor;
        g.O_j_local *= factor;
        g.formula = unscaled(std::move(g.formula), factor);
    }
    return mechanism;
}

}  // namespace jw
