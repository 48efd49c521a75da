#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Letters of formulas. Unicode has italic and bold letters of mathematics beyond 16 bits, which ImGui does
/// not support, so the formula fonts have them at private code points.
///
/// Letters are a-z, A-Z, Α-Ω, α-ω, ϵ, ϑ, ϕ, and digits for `math_bold`. Any other character stays unchanged:
/// it looks the same in every style.
namespace jw::render {

char32_t math_italic(char32_t letter);
char32_t math_bold(char32_t letter);
char32_t math_bold_italic(char32_t letter);

/// Where a font for mathematics has the letter that the formula fonts show at `code_point`.
struct MathGlyph {
    char32_t code_point;  ///< private, 16 bits
    char32_t unicode;
};

/// All letters of all styles.
std::vector<MathGlyph> math_glyphs();

/// UTF-8 for ImGui.
std::string to_utf8(std::u32string_view text);

}  // namespace jw::render
