#pragma once

#include "app/panels/parts/formula.hpp"

/// Puts pieces of formulas beside, above and around each other, without knowledge of the notation.
namespace jw::panels {

/// Puts `part` into `whole`; `at` is its place relative to the left end of the baseline of `whole`.
void put_into(Formula& whole, const Formula& part, Point at);

/// A glyph of the font, with the pen at 0 on the baseline.
Formula glyph_formula(const ImFont& font, char32_t c, Ink ink);

/// A delimiter that reaches at least from `ascent` to `descent`: the glyph, if necessary stretched, or lines.
Formula delimiter_formula(const ImFont& font, std::string_view drawn, float ascent, float descent);

/// @param axis  height of the line above the baseline
Formula fraction_formula(const Formula& above, const Formula& below, float em, float axis);
Formula root_formula(const ImFont& font, const Formula& inner);
/// A mark over the middle of `inner`. @param slanted  the letter below leans to the right
Formula accent_formula(const ImFont& font, const Formula& inner, char32_t mark, bool slanted, Ink ink);
/// `inner` with a line over its whole width.
Formula overlined_formula(const Formula& inner, float em);

/// Cells in rows and columns, centred on the axis.
/// @param left_aligned  false: each cell is in the middle of its column
Formula matrix_formula(
    const std::vector<std::vector<Formula>>& rows, float em, float axis, bool left_aligned);

}  // namespace jw::panels
