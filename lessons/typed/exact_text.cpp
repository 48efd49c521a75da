#include "lessons/typed/exact_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "core/elementary/elementary.hpp"
#include "core/jets/euler_parameters.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::writing {

namespace {

// digits that an author types for an axis or an angle; a number with more digits was computed
constexpr int kTypedDigits = 6;
constexpr int kLargestWhole = 9;
// this many digits identify every double
constexpr int kAllDigits = 17;
// the inverse of a rounded product or quotient is off by one neighbouring double at most
constexpr int kNeighbours = 2;

double rounded(double value, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return std::strtod(text.data(), nullptr);
}

std::string to_text(double value, std::chars_format format) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format).ptr;
    return {text.data(), end};
}

/// Multiples of `v` as somebody may have typed them: small whole numbers first, then with 1 for the largest.
std::vector<Vec3> short_multiples(const Vec3& v) {
    // a rounding error is not a component
    const Vec3 scaled =
        (v / v.cwiseAbs().maxCoeff()).unaryExpr([](double x) { return std::abs(x) > 1e-9 ? x : 0.0; });
    std::vector<Vec3> out;
    for (int largest = 1; largest <= kLargestWhole; ++largest) {
        const Vec3 whole = (largest * scaled).array().round();
        if ((whole - largest * scaled).cwiseAbs().maxCoeff() < 1e-9) { out.push_back(whole); }
    }
    out.push_back(scaled.unaryExpr([](double x) { return rounded(x, kTypedDigits); }));
    return out;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }

/// One character as it stands between quotes.
std::string escaped(char c) {
    switch (c) {
        case '"': return "\\\"";
        case '\\': return "\\\\";
        case '\t': return "\\t";
        case '\r': return "\\r";
        case '\n': return "\\n";
        default: break;
    }
    if (!is_control(c)) { return {c}; }
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "\\u%04X", static_cast<unsigned>(c));
    return text.data();
}

double degrees_turned(const Vec4& p) {
    return 2.0 * elementary::atan2(p.tail<3>().norm(), p(0)) * 180.0 / std::numbers::pi;
}

/// True for text with backslashes, as in formulas, that can be written without doubling them.
bool reads_better_literally(const std::string& text) {
    const auto is_special = [](char c) { return is_control(c) && c != '\n' && c != '\t'; };
    return text.find('\\') != std::string::npos && text.find("'''") == std::string::npos &&
           !text.ends_with('\'') && std::ranges::none_of(text, is_special);
}

std::string literal_text(const std::string& text) {
    const bool one_line = text.find('\n') == std::string::npos;
    if (one_line && text.find('\'') == std::string::npos) { return '\'' + text + '\''; }
    return (one_line ? "'''" : "'''\n") + text + "'''";
}

}  // namespace

std::string number_text(double value) {
    if (!std::isfinite(value)) {
        throw std::invalid_argument("a lesson has finite numbers only, not " + short_number(value));
    }
    if (value == 0.0) { return "0"; }
    const double size = std::abs(value);
    if (size >= 1e-4 && size < 1e10) { return to_text(value, std::chars_format::fixed); }
    std::string text = to_text(value, std::chars_format::scientific);
    // 1e-05 as people write it
    const std::size_t digits = text.find_last_of("+-") + 1;
    if (text[digits] == '0') { text.erase(digits, 1); }
    return text;
}

int digits_apart(double a, double b, int least) {
    int digits = least;
    while (a != b && digits < kAllDigits && rounded(a, digits) == rounded(b, digits)) { ++digits; }
    return digits;
}

std::string list_text(std::span<const double> values) { return list_text(values, number_text); }

std::string vector_text(const Vec3& v) { return list_text({v.data(), 3}); }

std::string string_text(const std::string& text) {
    if (reads_better_literally(text)) { return literal_text(text); }
    if (text.find('\n') == std::string::npos) {
        std::string out = "\"";
        for (const char c : text) { out += escaped(c); }
        return out + '"';
    }
    std::string out = "\"\"\"\n";
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        // one double quote alone does not need an escape; three of them would end the text
        const bool quote_alone = c == '"' && k + 1 < text.size() && (k == 0 || text[k - 1] != '"');
        const bool literal = c == '\n' || c == '\t' || quote_alone;
        out += literal ? std::string(1, c) : escaped(c);
    }
    return out + "\"\"\"";
}

std::string words_text(const std::string& text) {
    return string_text(text.find('\n') == std::string::npos ? text : text + '\n');
}

std::optional<double> typed_number(
    double guess, int most_digits, const std::function<bool(double)>& reads_back) {
    for (int digits = 1; digits <= most_digits; ++digits) {
        const double typed = rounded(guess, digits);
        if (reads_back(typed)) { return typed; }
    }
    if (most_digits < kAllDigits) { return std::nullopt; }
    double above = guess;
    double below = guess;
    for (int k = 0; k < kNeighbours; ++k) {
        above = std::nextafter(above, HUGE_VAL);
        below = std::nextafter(below, -HUGE_VAL);
        if (reads_back(above)) { return above; }
        if (reads_back(below)) { return below; }
    }
    return std::nullopt;
}

AngleTexts typed_angles(std::span<const double> radians_of) {
    AngleTexts texts{"deg", {}};
    for (const double angle : radians_of) {
        const auto reads_back = [&](double degrees) { return radians(degrees) == angle; };
        const auto degrees = typed_number(angle * 180.0 / std::numbers::pi, kAllDigits, reads_back);
        if (!degrees) { return {"rad", {radians_of.begin(), radians_of.end()}}; }
        texts.values.push_back(*degrees);
    }
    return texts;
}

Vec3 typed_direction(const Vec3& unit) {
    for (const Vec3& typed : short_multiples(unit)) {
        if (unit_of(typed) == unit) { return typed; }
    }
    return unit;
}

std::optional<TypedRotation> typed_rotation(const Vec4& p) {
    const Vec3 e = p.tail<3>();
    if (e.norm() == 0.0) { return std::nullopt; }
    const double angle = degrees_turned(p);
    for (const Vec3& axis : short_multiples(e)) {
        const auto degrees = typed_number(angle, kTypedDigits, [&](double typed) {
            return euler_parameters_of(axis, radians(typed)) == p;
        });
        if (degrees) { return TypedRotation{axis, *degrees}; }
    }
    return std::nullopt;
}

std::string about_rotation(const Vec4& p) {
    const Vec3 e = p.tail<3>();
    // + 0 turns -0 into 0
    const Vec3 axis = e.norm() > 0.0 ? Vec3(e.normalized() + Vec3::Zero()) : Vec3::UnitZ();
    std::string text = "turned by " + short_number(degrees_turned(p), 4) + " deg about (";
    for (const double x : axis) { text += (text.back() == '(' ? "" : ", ") + short_number(x, 3); }
    return text + ')';
}

}  // namespace jw::writing
