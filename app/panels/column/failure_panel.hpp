#pragma once

#include <string>

#include "app/panels/parts/parts.hpp"

namespace jw::panels {

/// Why a joint cannot be closed, or why the motion ends: joint, row, residual, cause and remedy, in a box of
/// its own.
/// @return height taken; 0 if nothing failed
float failure_panel(
    const Canvas& canvas, const Box& box, const std::string& title, const std::string& failure,
    Density density);

}  // namespace jw::panels
