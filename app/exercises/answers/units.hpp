#pragma once

#include <array>
#include <optional>
#include <string_view>

/// Units that answers are written in.
namespace jw {

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
