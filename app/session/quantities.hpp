#pragma once

#include "app/session/view.hpp"
#include "core/quantity/evaluate.hpp"
#include "core/quantity/names.hpp"

/// Quantities of a step and in words: what they are and how they are called is said in core/quantity.
namespace jw {

/// What is known at a step.
Instant instant_of(const Step& step);

/// What a person would measure first: what drivers prescribe, then the measures of joints that are not
/// driven.
std::vector<QuantityMotion> quantities_of(const Step& step);

/// "m/s", "deg", "rad/s²"; "-" if it has none. Angles are shown in degrees, angular velocities in radians.
std::string unit_text(const Quantity& quantity, int derivative);
/// What an angle is multiplied with for that, 1 for all others.
double factor_of_unit(const Quantity& quantity);

/// The same with the choice of the unit of angles, and with nothing where there is no unit: "1/s" for a rate.
std::string unit_text(UnitRate dimension, int derivative, bool in_degrees);

/// Why there is no number, in words.
std::string absence_text(Absence absence);

/// "energy.kinetic" to "kinetic_J": the column's name before there was one name for a quantity.
std::string column_of_before(const std::string& today);

}  // namespace jw
