#pragma once

#include <vector>

#include "core/motion/motion_equations.hpp"

namespace jw {

/// Changes the velocities of a flat start `y` so that velocities given with a mechanism are kept, if the
/// constraints allow all of them together to four digits; the others change as little as possible, in the
/// metric of M. A velocity that is not given is zero. `y` stays unchanged if the given ones cannot be kept,
/// and in mechanisms of more than 300 columns, whose free motions would take longer than their motion.
/// @param given with the velocities, and with frames as given
/// @param scene the same mechanism, centroidal
/// @param y satisfies the constraints, and its velocities are the nearest to all given ones, zeros included
void keep_given_velocities(
    const Mechanism& given, const Centroidal& scene, DrivableEquations& equations, std::vector<double>& y);

}  // namespace jw
