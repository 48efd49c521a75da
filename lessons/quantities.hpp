#pragma once

#include "core/quantity/names.hpp"
#include "lessons/reading.hpp"

/// Quantities that claims of a lesson name: "hinge.angle", "crank.x", "energy.sum".
namespace jw::reading {

/// The quantity that `text` names; where the name leaves a point open, also the key `point`.
std::optional<NamedQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading);

}  // namespace jw::reading
