#pragma once

#include <memory>

#include "core/motion/loads.hpp"
#include "lessons/lesson/lesson.hpp"

/// Joints and drivers of a lesson without those that were taken out.
namespace jw {

/// The mechanism with the joints and drivers that are added. The others keep their indices: a joint that was
/// taken out has no equations, and a driver that was taken out keeps a point of the ground where it is.
Mechanism taking_part(const Lesson& lesson);

/// Scene of the mechanism that takes part, with masses and loads, for energies and reactions; null for a
/// lesson without dynamics.
std::shared_ptr<const Centroidal> scene_of(const Lesson& lesson);

/// Checks that formulas of drivers and loads have a value, a rate and an acceleration from `from` to `to`.
/// The lesson's own times were checked when the lesson was read.
/// @throws std::invalid_argument with the name of the formula and the time
void require_formulas(const Lesson& lesson, double from, double to);

}  // namespace jw
