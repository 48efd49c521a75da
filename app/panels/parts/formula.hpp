#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "lessons/math/math.hpp"

/// Formulas as on the page, from the notation of docs/mathematics.md.
namespace jw::panels {

/// The fonts of one size.
struct FormulaFonts {
    const ImFont* base = nullptr;
    const ImFont* script = nullptr;
};

FormulaFonts formula_fonts(const render::Fonts& fonts);
FormulaFonts large_formula_fonts(const render::Fonts& fonts);
/// Fonts of formulas in a line of words of the font `words`.
FormulaFonts formula_fonts_beside(const render::Fonts& fonts, const ImFont& words);
/// Fonts of formulas in tables and pictures: the script font is also the base.
FormulaFonts small_formula_fonts(const render::Fonts& fonts);

/// Which body a vector belongs to: its colour is the one it has in the 3D picture.
enum class Ink { plain, vector_i, vector_j, vector_d };

struct FormulaGlyph {
    const ImFontGlyph* glyph = nullptr;
    Point origin;  ///< of the glyph's line box, from the left end of the formula's baseline
    Ink ink = Ink::plain;
    float stretch = 1.0F;  ///< in height, of delimiters and roots around what is tall
};
/// A line: of a fraction, a root or a bracket.
struct FormulaRule {
    Box box;  ///< from the left end of the baseline
};

/// A symbol of the formula, its dots and scripts included.
struct FormulaSymbol {
    Box box;             ///< from the left end of the baseline
    std::string source;  ///< see formula::TextSymbol
};

struct Formula {
    std::vector<FormulaGlyph> glyphs;
    std::vector<FormulaSymbol> symbols;
    std::vector<FormulaRule> rules;
    float width = 0.0F;
    float ascent = 0.0F;   ///< above the baseline, of what is really inked
    float descent = 0.0F;  ///< below it
};

/// Size of fractions and sums.
enum class MathStyle {
    in_line,  ///< fractions in small letters, so that lines stay apart
    display,
};

Formula layout_formula(const math::Row& row, const FormulaFonts& fonts, MathStyle style = MathStyle::in_line);
/// A formula of the program itself.
/// @throws std::invalid_argument if it is not written as docs/mathematics.md says
Formula layout_formula(std::string_view latex, const FormulaFonts& fonts);

/// @param colours  of vectors as in the picture; otherwise everything is drawn in `colour`
void draw_formula(
    const Canvas& canvas, Point baseline, const Formula& formula, Colour colour, bool colours = false);

/// The vectors of the formula can be pointed at; those that are lit are marked. Call before drawing it.
void link_formula(const Canvas& canvas, Point baseline, const Formula& formula, int joint);

/// The symbols of the formula that stand for something can be pointed at, and the one that is lit is marked.
/// Call before drawing it.
/// @param scope  see SymbolView
void link_symbols(const Canvas& canvas, Point baseline, const Formula& formula, std::string_view scope = {});

}  // namespace jw::panels
