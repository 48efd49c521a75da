#pragma once

#include <functional>
#include <span>

#include "lessons/fields/fields.hpp"
#include "lessons/formula/steps_of_formula.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

/// Makes a formula from its source. @throws formula::NotEvaluated
using FormulaReader = std::function<ScalarFormula(const std::string& source)>;

/// The formula under `key`; reports a text that is not such a formula.
/// @param made_of  what the formula may contain, for a hint
std::optional<ScalarFormula> read_formula(
    Fields& fields, const std::string& key, const FormulaReader& read, const char* made_of);

/// The formula of these variables under `key`; reports a text that is not such a formula.
/// @param made_of  what the formula may contain, for a hint
std::optional<ScalarFormula> read_scalar_formula(
    Fields& fields, const std::string& key, std::span<const formula::Variable> variables,
    const char* made_of);

/// Key `law` of a force or a torque, a formula of the time and of quantities; reports one that cannot be
/// read.
std::optional<LoadLaw> read_load_law(Fields& fields, const Reading& reading);

}  // namespace jw::reading
