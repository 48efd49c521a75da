#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/motion_equations.hpp"

namespace jw {

/// Largest velocity of a body or rate of a joint that is given with a mechanism [extents per second, rad/s].
double fastest_given_velocity(const Mechanism& mechanism);

/// True if a rate is the given one to four typed digits. If 0 is given, 1e-9 of the fastest given velocity
/// counts as rounding.
inline bool keeps_rate(double off, double given, double fastest) {
    return off <= std::max(1e-4 * std::abs(given), 1e-9 * fastest);
}

/// Largest number of moving bodies in which start rates of joints are kept: with so many, the dense
/// decompositions of a chain of hinges take half a second.
inline constexpr int kMostBodiesWithRates = 100;

/// Changes the velocities of a flat start `y` so that velocities of bodies and rates of joints given with a
/// mechanism are kept, if the constraints allow all of them together to four digits; the others change as
/// little as possible, in the metric of M. A velocity of a body that is not given is zero. If the given ones
/// cannot be kept together, those of a mechanism with start rates become the nearest in least squares;
/// without start rates, `y` stays unchanged. It also stays unchanged in larger mechanisms, whose free motions
/// would take longer to compute than their motion: above kMostBodiesWithRates, or 50 without start rates.
/// @param given mechanism with the given velocities, in the frames as given
/// @param scene the same mechanism, centroidal
/// @param y satisfies the constraints, and its velocities are the nearest to all given ones, zeros included
void keep_given_velocities(
    const Mechanism& given, const Centroidal& scene, DrivableEquations& equations, std::vector<double>& y);

}  // namespace jw
