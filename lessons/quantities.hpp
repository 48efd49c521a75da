#pragma once

#include "lessons/reading.hpp"

/// Quantities by their names in a lesson: "hinge.angle", "crank.x", "crank.omega.z".
namespace jw::reading {

struct MeasuredQuantity {
    Quantity quantity;
    Unit unit = Unit::none;
};

/// The quantity that `text` names; of a point also the key `point`.
std::optional<MeasuredQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading);

}  // namespace jw::reading
