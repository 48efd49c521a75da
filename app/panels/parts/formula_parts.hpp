#pragma once

#include "app/panels/parts/formula.hpp"

/// Pieces of formulas put beside, above and around each other; no notation is known here.
namespace jw::panels {

/// Puts `part` into `whole`, its baseline `down` below that of `whole`.
void put_into(Formula& whole, const Formula& part, Point at);

/// A glyph of the font, its pen at 0 on the baseline.
Formula glyph_formula(const ImFont& font, char32_t c, Ink ink);

/// A delimiter at least as tall as from `ascent` to `descent`: the glyph, stretched, or lines.
Formula delimiter_formula(const ImFont& font, std::string_view drawn, float ascent, float descent);

/// @param axis  height of the line above the baseline
Formula fraction_formula(const Formula& above, const Formula& below, float em, float axis);
Formula root_formula(const ImFont& font, const Formula& inner);
/// A mark over the middle of `inner`. @param slanted  the letter below leans to the right
Formula accent_formula(const ImFont& font, const Formula& inner, char32_t mark, bool slanted, Ink ink);
/// A line over all of `inner`.
Formula overlined_formula(const Formula& inner, float em);

/// Cells in rows and columns, in the middle on the axis.
/// @param left_aligned  else each is in the middle of its column
Formula matrix_formula(
    const std::vector<std::vector<Formula>>& rows, float em, float axis, bool left_aligned);

}  // namespace jw::panels
