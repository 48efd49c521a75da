#pragma once

#include <memory>

#include "core/motion/loads.hpp"
#include "lessons/lesson/lesson.hpp"

/// Joints and drivers of a lesson without those that were taken out.
namespace jw {

/// The mechanism as far as joints and drivers are added. Each keeps its place: no equation is left of a joint
/// that was taken out, and a driver that was taken out holds a point of the ground where it is.
Mechanism taking_part(const Lesson& lesson);

/// Scene of what takes part, with its masses and loads, for energies and reactions; null for a lesson without
/// dynamics.
std::shared_ptr<const Centroidal> scene_of(const Lesson& lesson);

/// Checks that formulas of drivers and loads have a value, a rate and an acceleration at all of these times;
/// for times beyond those of the lesson, for which reading it has checked that.
/// @throws std::invalid_argument with the name of the formula and the time
void require_formulas(const Lesson& lesson, double from, double to);

}  // namespace jw
