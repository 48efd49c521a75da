#pragma once

#include "core/equations/assembler.hpp"
#include "core/kinematics/proof/step_proof.hpp"

/// The cubic path through two poses and their velocities, and how well it satisfies the equations.
namespace jw {

/// Length of a step across a singular pose, which cannot be proved [rad, or units of length]: far enough that
/// branches separate by more than rounding, near enough that the cubic path satisfies the equations to
/// kCrossed.
inline constexpr double kCrossing = 1e-3;
inline constexpr double kCrossed = 1e-10;

/// Middle of the cubic path in (r, p) and θ.
State middle_of(const System& system, const PathEnd& from, const PathEnd& to);

/// True if no |Φ| is larger than `tolerance` times the unit of its row.
bool satisfies(Assembler<OmegaLocal>& assembler, const State& state, double t, double tolerance);

}  // namespace jw
