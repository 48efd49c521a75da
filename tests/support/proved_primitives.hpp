#pragma once

#include <vector>

#include "core/kinematics/proof/proved_equations.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Equations of proofs with random data; s_i and u are unit where a primitive asks for it.
namespace jw::test {

/// Those that are polynomials in r, p and θ.
inline std::vector<ProvedPrimitive> polynomial_primitives(Random& random) {
    const auto unit = [&] { return random.direction(); };
    const auto any = [&] { return random.vector(1.5); };
    return {
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
    return all;
}

}  // namespace jw::test
