#pragma once

#include <optional>
#include <string>

#include "lessons/formula/value.hpp"

/// Functions of values, with their derivatives along the motion.
namespace jw::formula {

/// A function of a number: its value and first two derivatives there.
Value function_of(const Value& a, double value, double first, double second);

/// Power of a number; of a matrix where the exponent is whole.
/// @throws NoValue for a root of a negative number and a division by zero
Value power(const Value& a, double n);
Value square_root(const Value& a);
/// Length of a vector, size of a number.
Value length(const Value& a);
/// Number 0 for the zero of any shape; any other value as it is.
Value as_number(const Value& a);

/// A function by its name: sin, det, rank; nothing if there is none of that name.
/// @throws Mismatch if it is taken of another shape, NoValue if it has no value there
std::optional<Value> value_of_function(const std::string& name, const Value& argument);

}  // namespace jw::formula
