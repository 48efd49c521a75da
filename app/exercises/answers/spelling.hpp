#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Spelling of answers: text from other keyboards and countries becomes ASCII, with decimal points; units.
namespace jw {

/// The text with Unicode signs, full-width signs and Python's ** replaced: "−１／４" becomes "-1/4".
std::string with_signs_of_keyboard(std::string_view text);

/// "0,5236" is 0.5236 and "0,5; 1,25" is 0.5 and 1.25: commas between digits are decimal points, at most one
/// in each of the expected numbers.
std::string with_decimal_points(std::string text, std::ptrdiff_t entries);

/// A unit in SI: its factor, and its powers of m, kg, s and rad.
struct WrittenUnit {
    double factor = 1.0;
    std::array<int, 4> powers{};

    bool operator==(const WrittenUnit&) const = default;
};

/// Reads "deg", "rad/s", "m/s^2", "N m", "kg m²", "°"; nothing for words that are not units. Empty text: no
/// unit.
std::optional<WrittenUnit> read_unit(std::string_view text);

}  // namespace jw
