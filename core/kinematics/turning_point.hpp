#pragma once

#include "core/equations/system.hpp"

/// Proof that a driven motion turns back.
namespace jw {

/// The only driver whose target changes at `t`; nullptr if none or several do.
const DriverConstraint* only_moving_driver(const System& system, double t);

/// True if it is proved that the motion turns back ahead of a pose: if its driver is released, the path that
/// continues from there comes to poses that the driver has already passed. So the driver has a largest value
/// on this branch, between these poses. The path is regular at that value; the driven motion is not.
///
/// The proof needs one driver that moves alone: if one of several is released, the others stay behind.
/// @param state satisfies the constraints at time `t`
/// @param velocity there; any size
/// @param sense 1 if time increases, -1 if the motion is followed backwards
bool turns_back(const System& system, const State& state, const Motion& velocity, double t, double sense);

}  // namespace jw
