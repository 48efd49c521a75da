#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/panels/parts/formula.hpp"
#include "lessons/math/text_parts.hpp"

/// Lines of words, formulas, and code on a shaded background.
namespace jw::panels {

/// Words, code or a formula, with the place in the line.
struct RichPiece {
    float x = 0.0F;
    std::string words;   ///< empty: a formula
    float shade = 0.0F;  ///< width of the shade behind code, from x on; 0: none
    Formula formula;
};
struct RichLine {
    std::vector<RichPiece> pieces;
    float ascent = 0.0F;  ///< above the baseline
    float descent = 0.0F;
    float width = 0.0F;
    bool display = false;  ///< a displayed formula
};
struct RichText {
    std::vector<RichLine> lines;
    float height = 0.0F;

    float width() const {
        return lines.empty() ? 0.0F : std::ranges::max_element(lines, {}, &RichLine::width)->width;
    }
};

/// Lays out a text with formulas in lines no wider than `width`. A formula that is wider than a line is
/// broken before its relations. A line feed begins a line.
RichText layout_rich(const render::Fonts& fonts, const ImFont& font, std::string_view text, float width);

/// The part of the text that fits into `height`: whole sentences are left out from the end, marked "…".
RichText layout_rich_to(
    const render::Fonts& fonts, const ImFont& font, std::string_view text, float width, float height);

void draw_rich(const Canvas& canvas, Point top_left, const ImFont* font, Colour colour, const RichText& text);

/// Place of a tip.
struct TipPlace {
    Box beside;  ///< subject of the tip, which the tip does not cover if there is room
    Box within;  ///< the tip stays in this box
};

/// Draws lines with formulas on a sheet of their size. Lines that are too wide or too high for the place are
/// left out.
/// @return the sheet; width 0 if nothing fits
Box draw_tip(const Canvas& canvas, const TipPlace& place, const std::vector<std::string>& lines);

}  // namespace jw::panels
