#pragma once

#include <string>

#include "core/quantity/evaluate.hpp"

/// Units of quantities as people read them, and why a quantity has no number.
namespace jw {

/// Unit of a derivative of a quantity: "m/s", "deg", "rad/s²"; "-" if it has none. Angles are shown in
/// degrees, angular velocities in radians.
std::string unit_text(const Quantity& quantity, int derivative);
/// Factor from SI to the unit that is shown: degrees per radian for angles, 1 for all others.
double factor_of_unit(const Quantity& quantity);

/// Unit of the derivative of a dimension, angles in degrees or radians; empty if it has none, "1/s" for the
/// rate of a number without a unit.
std::string unit_text(UnitRate dimension, int derivative, bool in_degrees);

/// Reason why there is no number.
std::string absence_text(Absence absence);

/// Old column name of a quantity, from before each quantity had one name everywhere: "kinetic_J" for
/// "energy.kinetic".
std::string column_of_before(const std::string& today);

}  // namespace jw
