#pragma once

#include <span>

#include "core/jets/formula_steps.hpp"
#include "lessons/formula/evaluate_formula.hpp"

namespace jw::formula {

/// A variable of a formula.
struct Variable {
    Symbol symbol;
    int index = 0;
    int rate = -1;  ///< index of the variable that a dot makes of it; -1: it has none
};

/// The time t as the only variable.
std::span<const Variable> time_only();

/// Formula of numbers and of these variables.
/// @throws NotEvaluated where it cannot be read, or something else stands
ScalarFormula scalar_formula(const std::string& source, std::span<const Variable> variables);

}  // namespace jw::formula
