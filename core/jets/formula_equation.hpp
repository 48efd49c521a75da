#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/jets/evaluate_steps.hpp"
#include "core/jets/vector_jet.hpp"

/// A constraint that an author writes as a formula of the vectors between two bodies.
namespace jw {

/// Vectors in a formula, all in the global frame. Variable 3 k + c of a formula is component c of vector k.
enum class FormulaVector {
    s_i,
    s_j,
    u_i,
    u_j,
    d,
    r_i,  ///< origin of the frame of body i [m]
    r_j,
    r_i_P,  ///< point P_i [m]
    r_j_P,
    A_i_x,  ///< columns of A_i: axes of the frame of body i
    A_i_y,
    A_i_z,
    A_j_x,
    A_j_y,
    A_j_z
};
inline constexpr std::size_t kFormulaVectors = 15;

/// Index of a variable of a formula.
constexpr int variable_of(FormulaVector vector, int component) {
    return 3 * static_cast<int>(vector) + component;
}

/// Equation that an author writes.
///
///   Φ = f(s_i, s_j, u_i, u_j, d, r_i, r_j, A_i, A_j)                            (1 equation)
///
/// Its derivatives follow from the rules of jets, step by step. Singular where f has no derivative.
struct FormulaEquation {
    static constexpr int kEquations = 1;
    ScalarFormula formula;  ///< its variables are the components of FormulaVector
    Vec3 s_i_local = Vec3::UnitZ();
    Vec3 s_j_local = Vec3::UnitZ();
    Vec3 u_i_local = Vec3::UnitX();
    Vec3 u_j_local = Vec3::UnitX();
    Vec3 P_i_local = Vec3::Zero();  ///< [m]
    Vec3 P_j_local = Vec3::Zero();  ///< [m]
    Vec3 O_i_local = Vec3::Zero();  ///< point with position r_i [m]
    Vec3 O_j_local = Vec3::Zero();  ///< point with position r_j [m]
    double by_length = 0.0;         ///< size of its gradient by positions [1/m], which a system sets
    double by_turn = 1.0;           ///< by turns of the bodies

    double unit(double length) const { return std::max(by_length * length, by_turn); }
    template <class F>
    void for_each_field(F&& f) const {
        f("formula", formula);
        f("s_i_local", s_i_local);
        f("s_j_local", s_j_local);
        f("u_i_local", u_i_local);
        f("u_j_local", u_j_local);
        f("P_i_local", P_i_local);
        f("P_j_local", P_j_local);
        f("O_i_local", O_i_local);
        f("O_j_local", O_j_local);
    }
};

namespace formula_steps {

inline constexpr unsigned kBoth = kBodyI | kBodyJ;

/// A number on the stack of a formula, with its derivatives in the coordinates C.
template <class C, Content K>
struct JetNumber {
    Jet<C, K, 1, kBoth> jet{};

    static JetNumber constant(double x) {
        JetNumber out;
        set_constant(out.jet, x);
        return out;
    }
    friend JetNumber operator+(const JetNumber& a, const JetNumber& b) {
        return {a.jet - scaled(-1.0, b.jet)};
    }
    friend JetNumber operator-(const JetNumber& a, const JetNumber& b) { return {a.jet - b.jet}; }
    friend JetNumber operator*(const JetNumber& a, const JetNumber& b) { return {dot(a.jet, b.jet)}; }
    friend JetNumber operator/(const JetNumber& a, const JetNumber& b) {
        return a * result_of(FormulaStep{FormulaStep::Kind::power, -1.0}, b);
    }
};

template <class C, Content K>
JetNumber<C, K> result_of(const FormulaStep& step, const JetNumber<C, K>& a) {
    return JetNumber<C, K>{applied(step, a.jet)};
}

}  // namespace formula_steps

/// Sets a jet to a constant.
template <class C, Content K, unsigned S>
void set_constant(Jet<C, K, 1, S>& out, double x) {
    out.value(0) = x;
    if constexpr (K == Content::motion) {
        out.rate(0) = out.bias(0) = 0.0;
    } else {
        out.block_i.setZero();
        out.block_j.setZero();
    }
}

/// Function of one operand, by its Taylor coefficients.
template <class C, Content K, unsigned S>
Jet<C, K, 1, S> applied(const FormulaStep& step, const Jet<C, K, 1, S>& x) {
    const auto f = formula_steps::result_of(step, Taylor<double, 3>::variable(x.value(0))).c;
    return chain(x, f[0], f[1], 2.0 * f[2]);
}

namespace detail {

/// Calls `f` with the jet of a vector of a formula.
template <Content K, class C, class F>
void visit_vector(
    FormulaVector vector, const FormulaEquation& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    F&& f) {
    const auto column = [&](FormulaVector first) {
        return Vec3::Unit(static_cast<int>(vector) - static_cast<int>(first)).eval();
    };
    switch (vector) {
        case FormulaVector::s_i: return f(arm<K, kBodyI>(i, c.s_i_local));
        case FormulaVector::s_j: return f(arm<K, kBodyJ>(j, c.s_j_local));
        case FormulaVector::u_i: return f(arm<K, kBodyI>(i, c.u_i_local));
        case FormulaVector::u_j: return f(arm<K, kBodyJ>(j, c.u_j_local));
        case FormulaVector::d: return f(vector_between<K>(i, c.P_i_local, j, c.P_j_local));
        case FormulaVector::r_i: return f(point<K, kBodyI>(i, c.O_i_local));
        case FormulaVector::r_j: return f(point<K, kBodyJ>(j, c.O_j_local));
        case FormulaVector::r_i_P: return f(point<K, kBodyI>(i, c.P_i_local));
        case FormulaVector::r_j_P: return f(point<K, kBodyJ>(j, c.P_j_local));
        case FormulaVector::A_i_x:
        case FormulaVector::A_i_y:
        case FormulaVector::A_i_z: return f(arm<K, kBodyI>(i, column(FormulaVector::A_i_x)));
        case FormulaVector::A_j_x:
        case FormulaVector::A_j_y:
        case FormulaVector::A_j_z: return f(arm<K, kBodyJ>(j, column(FormulaVector::A_j_x)));
    }
}

}  // namespace detail

template <Content K, class C>
Jet<C, K, 1, formula_steps::kBoth> equations(
    const FormulaEquation& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j,
    const ThetaOf<C>& /*theta*/) {
    using Number = formula_steps::JetNumber<C, K>;
    std::array<Number, 3 * kFormulaVectors> variables;
    for (std::size_t k = 0; k < kFormulaVectors; ++k) {
        const int first = 3 * static_cast<int>(k);
        if (!c.formula.uses_any(first, first + 3)) { continue; }
        detail::visit_vector<K>(static_cast<FormulaVector>(k), c, i, j, [&](const auto& w) {
            for (int n = 0; n < 3; ++n) {
                // the difference from 0 has the blocks of both bodies
                variables[static_cast<std::size_t>(first + n)].jet =
                    component(w, n) - Number::constant(0.0).jet;
            }
        });
    }
    return formula_steps::evaluated<Number>(c.formula.steps, variables).jet;
}

/// Bound of the rounding error of Φ: each step rounds by an epsilon times the size of its terms. The terms
/// can be far larger than the derivatives of Φ suggest, as in (10⁹ + d_x) - 10⁹.
template <class C>
double rounding(const FormulaEquation& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j) {
    std::array<double, 3 * kFormulaVectors> values{};
    for (std::size_t k = 0; k < kFormulaVectors; ++k) {
        const auto first = static_cast<int>(3 * k);
        if (!c.formula.uses_any(first, first + 3)) { continue; }
        detail::visit_vector<Content::jacobian>(static_cast<FormulaVector>(k), c, i, j, [&](const auto& w) {
            for (std::size_t n = 0; n < 3; ++n) { values[3 * k + n] = w.value(static_cast<Eigen::Index>(n)); }
        });
    }
    const auto steps = static_cast<double>(c.formula.steps.size());
    return steps * std::numeric_limits<double>::epsilon() * c.formula.size_at(values);
}

}  // namespace jw
