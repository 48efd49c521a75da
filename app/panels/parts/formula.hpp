#pragma once

#include <string_view>
#include <vector>

#include "app/panels/parts/canvas.hpp"

/// Formulas as on the page, from the markup of app/session/wording/labels.hpp, to which it adds `˙r` and
/// `¨r`: a bold letter under one or two dots.
namespace jw::panels {

/// The fonts of one size.
struct FormulaFonts {
    const ImFont* base = nullptr;
    const ImFont* script = nullptr;
};

FormulaFonts formula_fonts(const render::Fonts& fonts);
FormulaFonts large_formula_fonts(const render::Fonts& fonts);
/// Fonts of formulas in tables and pictures: the script font is also the base.
FormulaFonts small_formula_fonts(const render::Fonts& fonts);

/// Which body a vector belongs to: its colour is the one it has in the 3D picture.
enum class Ink { plain, vector_i, vector_j, vector_d };

struct FormulaGlyph {
    const ImFontGlyph* glyph = nullptr;
    Point origin;  ///< of the glyph's line box, from the left end of the formula's baseline
    Ink ink = Ink::plain;
};

struct Formula {
    std::vector<FormulaGlyph> glyphs;
    float width = 0.0F;
    float ascent = 0.0F;   ///< above the baseline, of what is really inked
    float descent = 0.0F;  ///< below it
};

Formula layout_formula(std::string_view markup, const FormulaFonts& fonts);

/// @param colours  of vectors as in the picture; otherwise everything is drawn in `colour`
void draw_formula(
    const Canvas& canvas, Point baseline, const Formula& formula, Colour colour, bool colours = false);

/// The vectors of the formula can be pointed at; those that are lit are marked. Call before drawing it.
void link_formula(const Canvas& canvas, Point baseline, const Formula& formula, int joint);

}  // namespace jw::panels
