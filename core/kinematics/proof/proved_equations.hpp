#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "core/equations/system.hpp"
#include "core/jets/majorants.hpp"

/// The equations of a system in a form for which a proof has bounds: polynomials in r and p, and functions of
/// θ and time whose derivatives have bounds.
namespace jw {

/// Φ = pᵀ p - 1 of body j.
struct UnitLength {};

template <Content K, class C>
auto equations(
    const UnitLength& /*c*/, const BodyKinematics<C>& /*i*/, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    const auto p = parameters<K, kBodyJ>(j);
    auto phi = dot(p, p);
    phi.value(0) -= 1.0;
    return phi;
}

/// Equation of a driver: its measure takes the value of a function of time, passed as θ. An angle is compared
/// by the sine of the difference, which is 0 at the same poses and does not jump.
template <Content K, class C>
auto equations(
    const AngleMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j, const ThetaOf<C>& target) {
    return equations<K>(
        ScrewAngle{m.s_i_local, m.u_i_local, m.u_j_local, ScrewAngleForm::rotation}, i, j, target);
}

template <Content K, class C>
auto equations(
    const SquaredDistanceMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& target) {
    const auto length = artificial<C, K>(target);
    return measured<K>(m, i, j, target) - dot(length, length);
}

template <Content K, class C>
auto equations(
    const DisplacementMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& target) {
    return measured<K>(m, i, j, target) - artificial<C, K>(target);
}

template <Content K, class C>
auto equations(
    const CoordinateMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& target) {
    return measured<K>(m, i, j, target) - artificial<C, K>(target);
}

/// θ of a screw minus its target: here, θ is the difference of both.
template <Content K, class C>
auto equations(
    const ThetaMeasure& m, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& difference) {
    return measured<K>(m, i, j, difference);
}

using ProvedPrimitive = std::variant<
    N1, N2, N2J, P1, P2, S, Distance, N1Pair, N2Pair, FormulaEquation, ScrewAdvance, ScrewAngle, Wheel,
    OnCurve, UnitLength, AngleMeasure, DisplacementMeasure, SquaredDistanceMeasure, CoordinateMeasure,
    ThetaMeasure>;

struct ProvedEquation {
    ProvedPrimitive primitive;
    int body_i = 0;
    int body_j = 0;
    int theta = -1;                        ///< artificial coordinate that is unknown, -1 if none
    const TimeFunction* target = nullptr;  ///< of a driver
    unsigned left_out = 0;                 ///< bit k: component k has no row
    double unit = 1.0;                     ///< size of a row where lengths are measured by the extent
    int rows = 1;

    bool has_row(int component) const { return ((left_out >> component) & 1U) == 0; }
};

/// All equations of a system and the normalisation of its moving bodies. p1 and p2 under the rule (or with
/// all three rows) become their pairs, which have the same solutions and do not lose rank for any axis.
std::vector<ProvedEquation> proved_equations(const System& system);

/// Calls `f` with the jet of an equation.
template <Content K, class C, class F>
void visit_equation(
    const ProvedEquation& equation, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& theta, F&& f) {
    std::visit([&](const auto& c) { f(equations<K>(c, i, j, theta)); }, equation.primitive);
}

}  // namespace jw
