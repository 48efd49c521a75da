#pragma once

#include <vector>

#include "core/dynamics/loads.hpp"

/// What the functions of time of a scene ask of the steps that follow a tolerance: no stage tells of what
/// lies between the stages.
namespace jw {

/// Times between 0 and `end` at which a driver or a load begins or ends to change, ascending, and `end` [s].
std::vector<double> events_until(double end, const Centroidal& scene);

/// Half the period of the fastest harmonic [s], infinite without any: the stages of a longer step might all
/// see the same of it.
double half_of_fastest_swing(const Centroidal& scene);

}  // namespace jw
