#pragma once

#include <string>
#include <vector>

#include "core/quantity/names.hpp"
#include "lessons/read/reading.hpp"

/// Quantities that claims of a lesson name: "hinge.angle", "crank.x", "energy.sum".
namespace jw::reading {

/// Endings of keys such as "value" for a quantity, one for each way to write its unit: "_deg_per_s" and
/// "_rad_per_s", or nothing.
std::vector<std::string> unit_endings(const Quantity& quantity, int derivative);

/// The quantity that `text` names; reads also the key `point` where the name does not give the point.
std::optional<NamedQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading);

}  // namespace jw::reading
