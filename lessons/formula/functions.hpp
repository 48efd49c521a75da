#pragma once

#include <optional>
#include <string>

#include "lessons/formula/value.hpp"

/// Functions of values, with their derivatives along the motion.
namespace jw::formula {

/// A function of the number `a`, from its value and first two derivatives at `a`.
Value function_of(const Value& a, double value, double first, double second);

/// Power of a number, or of a matrix if the exponent is whole.
/// @throws NoValue for a root of a negative number and a division by zero
Value power(const Value& a, double n);
Value square_root(const Value& a);
/// Length of a vector, absolute value of a number.
Value length(const Value& a);
/// The number 0 for a zero of any shape; any other value unchanged.
Value as_number(const Value& a);

/// Angle of a vector (x, y), without derivatives.
Value arc_tangent_of_two(const Value& y, const Value& x);

/// A function by its name: sin, det, rank; nothing if there is none of that name.
/// @throws Mismatch if the argument has the wrong shape, NoValue if the function has no value there
std::optional<Value> value_of_function(const std::string& name, const Value& argument);

}  // namespace jw::formula
