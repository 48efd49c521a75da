#pragma once

#include <vector>

#include "core/motion/loads.hpp"

/// Limits of adaptive steps from the scene's functions of time, because a method does not see what changes
/// between its stages.
namespace jw {

/// Time at which a step must end.
struct TimeEvent {
    double t = 0.0;      ///< [s]
    bool jumps = false;  ///< a derivative of a function of time jumps there
};

/// Times between 0 and `end` at which a driver or a load starts or stops changing, or between which a formula
/// swings at most once; ascending, then `end` [s].
std::vector<TimeEvent> events_until(double end, const Centroidal& scene);

/// Half the period of the fastest harmonic [s], infinite if there is none: in a longer step, all stages might
/// see the same phase of it.
double half_of_fastest_swing(const Centroidal& scene);

}  // namespace jw
