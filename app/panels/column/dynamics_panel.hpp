#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/dynamics_view.hpp"

namespace jw::panels {

/// The equations of motion of slide 24 with their numbers: M and Q of each body, λ of each joint, energies
/// and momenta.
/// @return height taken
float dynamics_panel(const Canvas& canvas, const Box& box, const DynamicsView& dynamics, Density density);

}  // namespace jw::panels
