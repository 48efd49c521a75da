#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/kinematics/proof/proved_equations.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Equations of proofs with random data; s_i and u are unit where a primitive asks for it.
namespace jw::test {

/// A formula of vectors of up to this length.
inline FormulaEquation formula_of(Random& random, double length, const authored::Part& left) {
    const auto any = [&] { return Vec3(length * random.number(0.2, 1.0) * random.direction()); };
    return {authored::equation(left, 0.3), any(), any(), any(), any(), any(), any()};
}

/// Polynomials of degree 2 in the vectors.
inline std::vector<ProvedPrimitive> polynomial_formulas(Random& random) {
    using namespace authored;
    using enum FormulaVector;
    return {
        formula_of(random, 1.5, dot(s_i, s_j)),
        formula_of(random, 1.5, dot(d, d) - number(2.0) * dot(u_i, r_j_P)),
        formula_of(
            random, 1.5, dot(r_i, A_j_y) + component(u_j, 2) * component(r_i_P, 0) - component(r_j, 1)),
        formula_of(random, 1.5, power(component(s_j, 0), 2.0) - dot(A_i_x, A_j_z) / number(4.0))};
}

/// Formulas that are not polynomials: bounded at all poses, or only if the bodies are not too far away.
inline std::vector<ProvedPrimitive> other_formulas(Random& random) {
    using namespace authored;
    using enum FormulaVector;
    return {
        formula_of(random, 1.0, sine(dot(s_i, s_j)) - cosine(number(0.5) * component(d, 1))),
        formula_of(random, 1.0, sine(dot(u_i, d)) * dot(s_j, d)),
        formula_of(random, 0.5, square_root(number(2.0) + dot(s_i, s_j))),
        formula_of(random, 0.5, dot(u_i, d) / (number(3.0) - dot(s_i, u_j))),
        formula_of(random, 0.5, power(number(2.5) + component(s_i, 0) * component(u_j, 0), -1.5)),
        formula_of(random, 0.5, square_root(number(0.1) + dot(d, d)))};
}

/// Those that are polynomials in r, p and θ.
inline std::vector<ProvedPrimitive> polynomial_primitives(Random& random) {
    const auto unit = [&] { return random.direction(); };
    const auto any = [&] { return random.vector(1.5); };
    std::vector<ProvedPrimitive> all{
        N1{any(), any()},
        N2{any(), any(), any()},
        N2J{any(), any(), any()},
        P1{any(), any()},
        P2{any(), any(), any()},
        S{any(), any()},
        Distance{any(), any(), 0.7},
        N1Pair{unit(), unit(), any()},
        N2Pair{unit(), unit(), any(), any()},
        ScrewAdvance{unit(), any(), any(), 0.3, 0.1, 0.2},
        UnitLength{},
        SquaredDistanceMeasure{any(), any()},
        DisplacementMeasure{unit(), any(), any()},
        CoordinateMeasure{1},
        CoordinateMeasure{5},
        ThetaMeasure{}};
    std::ranges::move(polynomial_formulas(random), std::back_inserter(all));
    return all;
}

inline std::vector<ProvedPrimitive> all_primitives(Random& random) {
    const auto unit = [&] { return random.direction(); };
    const auto any = [&] { return random.vector(1.5); };
    std::vector<ProvedPrimitive> all = polynomial_primitives(random);
    for (const auto form : {ScrewAngleForm::rotation, ScrewAngleForm::cosine, ScrewAngleForm::sine}) {
        all.push_back(ScrewAngle{unit(), unit(), unit(), form});
    }
    all.push_back(AngleMeasure{unit(), unit(), unit()});
    all.push_back(OnCurve{unit(), any(), any(), {0.3, -0.2, {{0.5, 0.1}, {-0.2, 0.3}}}});
    for (const auto line : {WheelLine::centres, WheelLine::normal, WheelLine::rack}) {
        all.push_back(Wheel{line, true, unit(), unit(), unit(), any(), any(), -1.7});
    }
    all.push_back(Wheel{WheelLine::centres, false, unit(), unit(), unit(), any(), any(), 1.0});
    all.push_back(Wheel{WheelLine::normal, false, unit(), unit(), unit(), any(), any(), 0.6});
    std::ranges::move(other_formulas(random), std::back_inserter(all));
    return all;
}

}  // namespace jw::test
