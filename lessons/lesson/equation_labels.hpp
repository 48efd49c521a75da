#pragma once

#include <string>
#include <vector>

#include "core/model/mechanism.hpp"

/// Short names of a joint's equations, the same in lessons and beside the rows of a matrix: "s x", "p1 y",
/// "θ".
namespace jw {

/// "s", "p1", "n1 pair", "θ".
std::string primitive_name(Role role, ParallelForm form);
/// "x"; "a" or "b" of a pair, empty for a primitive of one equation.
std::string component_name(int equations, int component);

struct LabelledEquation {
    std::string label;  ///< primitive and component, "p1 y"
    EquationOut equation;
};
/// All equations of a joint in this form, in the order of its primitives, also those that are left out.
std::vector<LabelledEquation> equations_of(const JointType& type, ParallelForm form);

}  // namespace jw
