#pragma once

#include "core/motion/loads.hpp"
#include "tests/reference/general/model.hpp"

/// A mechanism of core as a model of the general reference solver: the data only. Every joint type is written
/// out here from the slides; core's table of roles has no part in it.
namespace jw::test {

/// @throws std::invalid_argument for a joint type or a form that is not known here
reference::general::Model model_of(const Mechanism& mechanism, const Loads& loads);

/// Equations of one joint, in the order of its type; `of` is its index.
std::vector<reference::general::Equation> equations_of_joint(const Joint& joint, int of);
/// The angle that θ of a gear, a belt or a rack is.
reference::general::WheelAngle first_wheel_of(const Joint& joint);
reference::general::Equation equation_of_driver(const Mechanism& mechanism, const Driver& driver, int of);

}  // namespace jw::test
