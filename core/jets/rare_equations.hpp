#pragma once

#include "core/jets/formula_equation.hpp"
#include "core/jets/wheels_and_curves.hpp"

/// Equations of few scenes: compiled once for each coordinate choice, by rare_equations.cpp, and not again by
/// each source that evaluates equations of all kinds. (`WHERE` is `extern` in all sources but that one.)
#define JW_RARE_EQUATION(WHERE, C, K, FUNCTION, EQUATION, SIDES) \
    WHERE template Jet<C, K, 1, SIDES> FUNCTION<K, C>(           \
        const EQUATION&, const BodyKinematics<C>&, const BodyKinematics<C>&, const Theta&);
#define JW_RARE_EQUATIONS_IN(WHERE, C, K)                                        \
    JW_RARE_EQUATION(WHERE, C, K, equations, FormulaEquation, (kBodyI | kBodyJ)) \
    JW_RARE_EQUATION(WHERE, C, K, equations, Wheel, (kBodyI | kBodyJ | kTheta))  \
    JW_RARE_EQUATION(WHERE, C, K, equations, OnCurve, (kBodyI | kBodyJ | kTheta))
#define JW_RARE_EQUATIONS(WHERE)                                                               \
    JW_RARE_EQUATIONS_IN(WHERE, TrueEulerParameters, Content::jacobian)                        \
    JW_RARE_EQUATIONS_IN(WHERE, TrueEulerParameters, Content::motion)                          \
    JW_RARE_EQUATIONS_IN(WHERE, ModifiedEulerParameters, Content::jacobian)                    \
    JW_RARE_EQUATIONS_IN(WHERE, ModifiedEulerParameters, Content::motion)                      \
    JW_RARE_EQUATIONS_IN(WHERE, OmegaLocal, Content::jacobian)                                 \
    JW_RARE_EQUATIONS_IN(WHERE, OmegaLocal, Content::motion)                                   \
    JW_RARE_EQUATIONS_IN(WHERE, OmegaGlobal, Content::jacobian)                                \
    JW_RARE_EQUATIONS_IN(WHERE, OmegaGlobal, Content::motion)                                  \
    JW_RARE_EQUATION(WHERE, OmegaLocal, Content::jacobian, measured, Wheel, (kBodyI | kBodyJ)) \
    JW_RARE_EQUATION(WHERE, OmegaLocal, Content::motion, measured, Wheel, (kBodyI | kBodyJ))

namespace jw {

JW_RARE_EQUATIONS(extern)

}  // namespace jw
