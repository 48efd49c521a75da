#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Newton-Raphson, one line an iteration; the last is the step's and stands out. Earlier ones give way where
/// there is no room.
/// @return height taken
float newton_panel(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows, Density density);

}  // namespace jw::panels
