#pragma once

#include <memory>

#include "core/quantity/evaluate.hpp"
#include "lessons/formula/evaluate_formula.hpp"
#include "lessons/formula/subject.hpp"

/// Symbols of the book and what they are at an instant of a mechanism.
namespace jw::formula {

/// Meanings at an instant that knows state and velocity, and accelerations if they are asked for.
/// The instant must outlive them.
Meanings meanings_of(const Subject& subject, const Instant& instant);

/// The equation at an instant.
Outcome evaluate_at(const Formula& formula, const Instant& instant);

/// An instant of `system` with arbitrary unit p, positions, velocities and accelerations of all bodies, the
/// fixed ones included: the same for the same seed.
Instant arbitrary_instant(std::shared_ptr<const System> system, unsigned seed);

}  // namespace jw::formula
