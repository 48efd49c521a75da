#pragma once

#include <optional>
#include <string>

#include "core/motion/loads.hpp"
#include "tests/support/generators/recipe.hpp"

/// Turns recipes into mechanisms that are assembled and move along their constraints.
namespace jw::test {

/// A mechanism with loads whose start satisfies Φ = 0 and Φq q̇ = ν to rounding.
struct Generated {
    Mechanism mechanism;
    Loads loads;
    Recipe recipe;
    int rank = 0;            ///< of Φq at the start, in long double
    int freedoms = 0;        ///< 6 per body that moves, less the rank
    double condition = 1.0;  ///< of the independent rows, in the metric of M
    double length = 1.0;     ///< size of the scene [m]
    int left_out = 0;        ///< parts of the recipe that could not be taken
};

/// Mechanism of a recipe. Bodies are put anywhere; joints and drivers are fitted to that pose, so that every
/// loop closes. Velocities are those nearest to random ones, in the metric of M, that the constraints allow,
/// found by the reference solver. A joint or driver that would contradict the others is left out.
/// @return nothing where the start is singular: redundant equations there require another acceleration
std::optional<Generated> mechanism_of(const Recipe& recipe);

}  // namespace jw::test
