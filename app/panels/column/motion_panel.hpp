#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Angles and displacements of joints with their rates; driven ones are marked.
/// @return height taken
float quantities_panel(const Canvas& canvas, const Box& box, const View& view, Density density);

/// r, ṙ and ω of every body, in columns of constant width; accelerations too if there is room.
float bodies_motion_panel(
    const Canvas& canvas, const Box& box, const std::vector<BodyMotion>& bodies, Density density);

/// r and p of every body: the start of the free bodies.
float coordinates_panel(
    const Canvas& canvas, const Box& box, const std::vector<BodyMotion>& bodies, Density density);

}  // namespace jw::panels
