#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Numbers and texts as they are written in a lesson file. Reading them gives the same values again.
namespace jw::writing {

/// The shortest decimal that reads back to the same double: 0.3, 1e-12, -5. Minus zero becomes 0.
std::string number_text(double value);
/// Fewest digits, from `least` to 17, with which two different numbers are written differently.
int digits_apart(double a, double b, int least);
/// "[a, b]", each entry as `text_of` writes it.
template <class List, class TextOf>
std::string list_text(const List& entries, TextOf&& text_of) {
    std::string text;
    for (const auto& entry : entries) { text += (text.empty() ? "" : ", ") + text_of(entry); }
    return '[' + text + ']';
}
/// "[0, 0.5, 1]"
std::string list_text(std::span<const double> values);
std::string vector_text(const Vec3& v);

/// Text in TOML, in double quotes with escapes; text with backslashes, if possible, in single quotes without
/// escapes. Triple quotes are used where they are needed.
std::string string_text(const std::string& text);
/// Text in TOML whose trailing line feeds do not matter: after several lines, the closing quotes have their
/// own line.
std::string words_text(const std::string& text);

/// The number near `guess` with the fewest digits, at most `most_digits`, that reads back as required.
std::optional<double> typed_number(
    double guess, int most_digits, const std::function<bool(double)>& reads_back);

/// Angles in the unit in which they were typed, the same unit for all.
struct AngleTexts {
    std::string unit;  ///< "deg", or "rad" where no number of degrees reads back exactly
    std::vector<double> values;
};
AngleTexts typed_angles(std::span<const double> radians_of);

/// A short vector that gives exactly `unit` when it is normalised; `unit` itself if there is none.
Vec3 typed_direction(const Vec3& unit);

/// Axis and angle [deg] with few digits that give exactly `p`.
struct TypedRotation {
    Vec3 axis;
    double angle_deg = 0.0;
};
std::optional<TypedRotation> typed_rotation(const Vec4& p);
/// "turned by 30 deg about (0, 0, 1)", rounded: for comments.
std::string about_rotation(const Vec4& p);

}  // namespace jw::writing
