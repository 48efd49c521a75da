#pragma once

#include "app/session/view.hpp"

/// The equations of a joint or driver with their live values; used by view.cpp only.
namespace jw {

/// @param report of the step's pose: which rows are redundant. May be nullptr
/// @param choices of the joint's p1 and p2, in the order of its primitives; may be empty
std::vector<EquationGroup> equations_of_joint(
    const Step& step, int joint, const std::vector<RowChoice>& choices, const RankReport* report);
EquationGroup equation_of_driver(const Step& step, int driver, const RankReport* report);

/// Why these rows are kept, at the step's state.
/// @param before the system of the step before, whose choice may have been another; may be nullptr
std::vector<RowChoice> choices_of_joint(
    const System& system, int joint, const State& state, const System* before);

ChoiceView choice_view_of(const RowChoice& choice);

}  // namespace jw
