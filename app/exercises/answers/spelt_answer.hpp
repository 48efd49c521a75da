#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Spelling of answers: text from other keyboards and countries becomes ASCII, with decimal points.
namespace jw {

/// The text with Unicode signs, full-width signs and Python's ** replaced: "−１／４" becomes "-1/4".
std::string with_signs_of_keyboard(std::string_view text);

/// "0,5236" is 0.5236 and "0,5; 1,25" is 0.5 and 1.25: commas between digits are decimal points, at most one
/// in each of the expected numbers.
std::string with_decimal_points(std::string text, std::ptrdiff_t entries);

}  // namespace jw
