#pragma once

#include "core/model/mechanism.hpp"
#include "tests/reference/general/model.hpp"

/// Formulas of authors in the words of the general reference solver.
namespace jw::test {

/// The tree of operations that steps for a stack do.
reference::general::FormulaTree tree_of(const std::vector<FormulaStep>& steps);

/// The equation of a formula joint. Three formulas say what other measures say, and have those; the others
/// are trees of operations.
reference::general::Equation equation_of_formula(const Joint& joint, int of);

}  // namespace jw::test
