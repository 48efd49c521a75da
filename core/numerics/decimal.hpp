#pragma once

#include <charconv>

namespace jw {

/// Number that a text begins with, as std::from_chars reads it: the nearest double, including "inf" and
/// "nan", independent of the locale; without a sign + and without a space before it. Some standard libraries
/// lack std::from_chars for double (libc++ up to version 18).
/// @param[out] value  unchanged unless a number was read
/// @return end of the number and an error as std::from_chars gives it
std::from_chars_result read_decimal(const char* first, const char* last, double& value);

/// The same by std::strtod, in the locale "C": used by read_decimal where std::from_chars is missing.
std::from_chars_result read_decimal_by_strtod(const char* first, const char* last, double& value);

}  // namespace jw
