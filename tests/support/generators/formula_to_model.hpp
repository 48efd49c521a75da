#pragma once

#include "core/model/mechanism.hpp"
#include "tests/reference/general/model.hpp"

/// Translation of authors' formulas for the general reference solver.
namespace jw::test {

/// The tree of the operations that the steps of a stack machine do.
reference::general::FormulaTree tree_of(const std::vector<FormulaStep>& steps);

/// The equation of a formula joint. Three formulas are equal to other measures, and use those; the others are
/// trees of operations.
reference::general::Equation equation_of_formula(const Joint& joint, int of);

}  // namespace jw::test
