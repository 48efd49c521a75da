#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Newton-Raphson, one line per iteration. The last one is that of the step, and is highlighted. Earlier ones
/// are left out if there is not enough room.
/// @return height taken
float newton_panel(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows, Density density);

}  // namespace jw::panels
