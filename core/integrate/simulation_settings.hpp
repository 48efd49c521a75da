#pragma once

#include <optional>

#include "core/integrate/methods.hpp"
#include "core/jets/coordinates.hpp"
#include "core/motion/tolerances.hpp"

namespace jw {

/// Settings of a simulation.
struct SimulationSettings {
    Method method = Method::explicit_8;
    Treatment treatment = Treatment::projection;
    double tolerance = kUsualTolerance;  ///< tolerance of adaptive methods
    double step = 1e-3;                  ///< step of the others [s]
    long most_steps = kMostStepsTaken;
    double baumgarte = 20.0;  ///< α = β of Baumgarte's stabilisation [1/s]
    /// Coordinates that are integrated; the semi-implicit method supports bodies only.
    Formulation formulation = Formulation::automatic;
    /// If set, the dense equations of the slides in these coordinates are integrated instead.
    std::optional<CoordinateChoice> dense;
};

}  // namespace jw
