#pragma once

#include "app/session/view.hpp"
#include "core/equations/assembler.hpp"

/// What a person would measure on a mechanism in motion: angles and displacements of joints, drivers.
namespace jw {

/// Drivers first, then the angles and displacements of joints that are not driven.
std::vector<QuantityMotion> quantities_of(const Step& step);

/// A distance from its square: with D = d², Ḋ = 2 d ḋ and D̈ = 2 ḋ² + 2 d d̈.
Measured distance_of(const Measured& squared);

/// "pivot.angle" of a joint or of what a driver drives.
std::string driver_quantity_name(const Mechanism& mechanism, const Driver& driver);

}  // namespace jw
