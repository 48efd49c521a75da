#pragma once

#include <memory>

#include "core/quantity/evaluate.hpp"
#include "lessons/formula/evaluate_formula.hpp"
#include "lessons/formula/subject.hpp"

/// Values of the book's symbols at an instant of a mechanism.
namespace jw::formula {

/// Meanings at an instant that has a state and velocities, and also accelerations if a formula needs them.
/// The instant must outlive the meanings.
Meanings meanings_of(const Subject& subject, const Instant& instant);

/// Evaluates the equation at an instant.
Outcome evaluate_at(const Formula& formula, const Instant& instant);

/// An instant of `system` with arbitrary unit p, positions, velocities and accelerations of all bodies, fixed
/// ones included. The same seed gives the same instant.
Instant arbitrary_instant(std::shared_ptr<const System> system, unsigned seed);

}  // namespace jw::formula
