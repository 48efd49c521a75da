#pragma once

#include <span>

#include "lessons/fields/fields.hpp"
#include "lessons/formula/steps_of_formula.hpp"

namespace jw::reading {

/// The formula under `key`; reports what it cannot be made of.
/// @param made_of  what it can be made of, for a hint
std::optional<ScalarFormula> read_scalar_formula(
    Fields& fields, const std::string& key, std::span<const formula::Variable> variables,
    const char* made_of);

}  // namespace jw::reading
