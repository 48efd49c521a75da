#pragma once

#include <charconv>

namespace jw {

/// Number of a text as std::from_chars reads it: the nearest double, "inf" and "nan" among them, whatever the
/// locale; no sign + and no space before it. Standard libraries lack it for double (libc++ up to version 18).
/// @param[out] value  left alone unless a number was read
/// @return end of what was read and an error as of std::from_chars
std::from_chars_result read_decimal(const char* first, const char* last, double& value);

/// Number of a text by std::strtod, in the locale "C": what read_decimal does where std::from_chars is
/// missing.
std::from_chars_result read_decimal_by_strtod(const char* first, const char* last, double& value);

}  // namespace jw
