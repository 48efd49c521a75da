#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Numbers and texts as they stand in a lesson file, such that reading them gives the same again.
namespace jw::writing {

/// The shortest decimal that reads back to the same double: 0.3, 1e-12, -5. Minus zero becomes 0.
std::string number_text(double value);
/// Fewest digits, at least `least` and at most 17, with which two numbers that differ read differently.
int digits_apart(double a, double b, int least);
/// "[0, 0.5, 1]"
std::string list_text(std::span<const double> values);
std::string vector_text(const Vec3& v);

/// Text in TOML: in double quotes, or between triple ones where it has several lines. Everything that TOML
/// does not take literally is escaped.
std::string string_text(const std::string& text);
/// Text in TOML whose line feeds at the end do not count: several lines get a line each.
std::string words_text(const std::string& text);

/// The number with the fewest digits, at most `most_digits`, near `guess` that reads back as it should.
std::optional<double> typed_number(
    double guess, int most_digits, const std::function<bool(double)>& reads_back);

/// Angles in the unit in which they were typed, all in the same.
struct AngleTexts {
    std::string unit;  ///< "deg", or "rad" where no number of degrees reads back exactly
    std::vector<double> values;
};
AngleTexts typed_angles(std::span<const double> radians_of);

/// A short vector whose direction, made unit, is exactly `unit`; `unit` itself if there is none.
Vec3 typed_direction(const Vec3& unit);

/// Axis and angle [deg] with few digits that give exactly `p`, if there are such.
struct TypedRotation {
    Vec3 axis;
    double angle_deg = 0.0;
};
std::optional<TypedRotation> typed_rotation(const Vec4& p);
/// "turned by 30 deg about (0, 0, 1)", rounded: for comments.
std::string about_rotation(const Vec4& p);

}  // namespace jw::writing
