#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/jets/formula_steps.hpp"
#include "lessons/formula/evaluate_formula.hpp"

namespace jw::formula {

/// A variable of a formula.
struct Variable {
    Symbol symbol;
    int index = 0;
    int rate = -1;  ///< index of its rate, the symbol with a dot; -1: it has none
};

/// The time t as the only variable.
std::span<const Variable> time_only();

/// Formula of numbers and of these variables.
/// @param quantities  index of the variable that the words in \text name, if there may be any
/// @throws NotEvaluated if it cannot be read, or contains anything else
ScalarFormula scalar_formula(
    const std::string& source, std::span<const Variable> variables,
    const std::function<std::optional<int>(const std::string& name)>& quantities = {});

/// Equation between two bodies, Φ or Φ = 0 or left = right, of the components of FormulaVector. It is written
/// with s_i, s_j, u_i, u_j, d, r_i, r_j, r_i^P, r_j^P, s_i^P, s_j^P, A_i and A_j.
/// @throws NotEvaluated if it cannot be read, is not one number or depends on anything else
ScalarFormula constraint_formula(const std::string& source);

}  // namespace jw::formula
