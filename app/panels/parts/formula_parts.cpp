#include "app/panels/parts/formula_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"

namespace jw::panels {

namespace {

// in parts of the font size, as in books set with Latin Modern
constexpr float kAccentGap = 0.02F;
constexpr float kSlant = 0.06F;        ///< shift of a mark to the right of the middle of a slanted letter
constexpr float kRule = 0.045F;        ///< thickness of lines
constexpr float kFractionGap = 0.13F;  ///< between the line and the parts above and below it
constexpr float kFractionSide = 0.12F;
constexpr float kRootGap = 0.12F;
constexpr float kBetweenColumns = 0.8F;
constexpr float kRowGap = 0.22F;
constexpr float kLeastRow = 0.75F;
constexpr float kBracketWidth = 0.22F;

float thickness(float em) { return std::max(1.0F, std::round(kRule * em)); }

void add_rule(Formula& formula, const Box& box) {
    formula.rules.push_back(box);
    formula.ascent = std::max(formula.ascent, -box.y);
    formula.descent = std::max(formula.descent, box.bottom());
}

/// Draws [, ], | and ‖ as lines, which are sharp at any height.
Formula bracket_of_lines(std::string_view drawn, float em, float ascent, float descent) {
    Formula bracket;
    const float line = thickness(em);
    const float top = -std::ceil(ascent);
    const float height = std::ceil(ascent) + std::ceil(descent);
    if (drawn == "|" || drawn == "‖") {
        add_rule(bracket, {std::round(0.1F * em), top, line, height});
        if (drawn == "‖") { add_rule(bracket, {std::round(0.28F * em), top, line, height}); }
        bracket.width = drawn == "|" ? 0.28F * em : 0.46F * em;
        return bracket;
    }
    const bool left = drawn == "[";
    const float width = std::round(kBracketWidth * em);
    const float side = std::round(0.06F * em);
    add_rule(bracket, {left ? side : side + width - line, top, line, height});
    add_rule(bracket, {side, top, width, line});
    add_rule(bracket, {side, top + height - line, width, line});
    bracket.width = width + 2.0F * side;
    return bracket;
}

}  // namespace

void put_into(Formula& whole, const Formula& part, Point at) {
    for (FormulaGlyph glyph : part.glyphs) {
        glyph.origin = {glyph.origin.x + at.x, glyph.origin.y + at.y};
        whole.glyphs.push_back(glyph);
    }
    for (FormulaSymbol symbol : part.symbols) {
        symbol.box.x += at.x;
        symbol.box.y += at.y;
        whole.symbols.push_back(std::move(symbol));
    }
    for (const Box& rule : part.rules) {
        whole.rules.push_back({rule.x + at.x, rule.y + at.y, rule.width, rule.height});
    }
    whole.width = std::max(whole.width, at.x + part.width);
    if (part.glyphs.empty() && part.rules.empty()) { return; }
    whole.ascent = std::max(whole.ascent, part.ascent - at.y);
    whole.descent = std::max(whole.descent, part.descent + at.y);
}

Formula glyph_formula(const ImFont& font, char32_t c, Ink ink) {
    Formula formula;
    const ImFontGlyph& glyph = *font.FindGlyph(static_cast<ImWchar>(c));
    const float up = std::round(font.Ascent);
    formula.glyphs.push_back({&glyph, {0.0F, -up}, ink});
    formula.width = glyph.AdvanceX;
    if (glyph.Visible != 0) {
        formula.ascent = std::max(0.0F, up - glyph.Y0);
        formula.descent = std::max(0.0F, glyph.Y1 - up);
    }
    return formula;
}

Formula delimiter_formula(const ImFont& font, std::string_view drawn, float ascent, float descent) {
    if (drawn.empty()) { return {}; }
    const float em = font.FontSize;
    const std::u32string points = from_utf8(drawn);
    Formula normal = glyph_formula(font, points[0], Ink::plain);
    if (ascent <= normal.ascent + 0.05F * em && descent <= normal.descent + 0.05F * em) { return normal; }
    if (drawn == "[" || drawn == "]" || drawn == "|" || drawn == "‖") {
        return bracket_of_lines(drawn, em, ascent, descent);
    }
    FormulaGlyph& glyph = normal.glyphs[0];
    const float height = glyph.glyph->Y1 - glyph.glyph->Y0;
    glyph.stretch = (ascent + descent) / std::max(1.0F, height);
    glyph.origin.y = -ascent - glyph.stretch * glyph.glyph->Y0;
    normal.ascent = ascent;
    normal.descent = descent;
    return normal;
}

Formula fraction_formula(const Formula& above, const Formula& below, float em, float axis) {
    Formula fraction;
    const float side = kFractionSide * em;
    const float width = std::max(above.width, below.width) + 2.0F * side;
    const float line = thickness(em);
    const float y = -std::round(axis) - std::floor(0.5F * line);
    const float gap = kFractionGap * em;
    put_into(fraction, above, {0.5F * (width - above.width), std::round(y - gap - above.descent)});
    put_into(fraction, below, {0.5F * (width - below.width), std::round(y + line + gap + below.ascent)});
    add_rule(fraction, {0.3F * side, y, width - 0.6F * side, line});
    fraction.width = width;
    return fraction;
}

Formula root_formula(const ImFont& font, const Formula& inner) {
    const float em = font.FontSize;
    const float line = thickness(em);
    const float gap = kRootGap * em;
    Formula sign = delimiter_formula(font, "√", inner.ascent + gap + line, inner.descent + 0.1F * em);
    // a root sign that is not stretched may be taller than its contents
    const float top = std::round(sign.ascent);
    Formula root;
    put_into(root, sign, {});
    put_into(root, inner, {sign.width, 0.0F});
    add_rule(root, {sign.width - 0.06F * em, -top, inner.width + 0.1F * em, line});
    root.width = sign.width + inner.width + 0.08F * em;
    return root;
}

Formula accent_formula(const ImFont& font, const Formula& inner, char32_t mark, bool slanted, Ink ink) {
    Formula accented = inner;
    const ImFontGlyph& glyph = *font.FindGlyph(static_cast<ImWchar>(mark));
    const float em = font.FontSize;
    float left = 0.0F;
    float right = inner.width;
    if (inner.glyphs.size() == 1) {
        left = inner.glyphs[0].origin.x + inner.glyphs[0].glyph->X0;
        right = inner.glyphs[0].origin.x + inner.glyphs[0].glyph->X1;
    }
    const float middle = 0.5F * (left + right) + (slanted ? kSlant * em : 0.0F);
    Formula over;
    over.glyphs.push_back(
        {&glyph,
         {middle - 0.5F * (glyph.X0 + glyph.X1), std::round(-inner.ascent - kAccentGap * em - glyph.Y1)},
         ink});
    over.ascent = -(over.glyphs[0].origin.y + glyph.Y0);
    put_into(accented, over, {});
    accented.width = inner.width;
    return accented;
}

Formula overlined_formula(const Formula& inner, float em) {
    Formula lined = inner;
    const float line = thickness(em);
    const float y = -std::round(inner.ascent + 0.1F * em) - line;
    add_rule(lined, {0.06F * em, y, std::max(line, inner.width - 0.08F * em), line});
    lined.width = inner.width;
    return lined;
}

Formula matrix_formula(
    const std::vector<std::vector<Formula>>& rows, float em, float axis, bool left_aligned) {
    std::vector<float> widths;
    float height = 0.0F;
    struct Line {
        float ascent = 0.0F;
        float descent = 0.0F;
    };
    std::vector<Line> lines;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0.0F);
        Line line{kLeastRow * em, 0.1F * em};
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], row[c].width);
            line = {std::max(line.ascent, row[c].ascent), std::max(line.descent, row[c].descent)};
        }
        height += line.ascent + line.descent + (lines.empty() ? 0.0F : kRowGap * em);
        lines.push_back(line);
    }
    Formula matrix;
    float top = -axis - 0.5F * height;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const float baseline = std::round(top + lines[r].ascent);
        float x = 0.0F;
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            const float free = left_aligned ? 0.0F : 0.5F * (widths[c] - rows[r][c].width);
            put_into(matrix, rows[r][c], {x + free, baseline});
            x += widths[c] + (c + 1 < widths.size() ? kBetweenColumns * em : 0.0F);
        }
        matrix.width = std::max(matrix.width, x);
        top += lines[r].ascent + lines[r].descent + kRowGap * em;
    }
    return matrix;
}

}  // namespace jw::panels
