#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "lessons/math/math.hpp"

/// Formulas as on paper, from the notation of docs/mathematics.md.
namespace jw::panels {

/// The fonts of one size.
struct FormulaFonts {
    const ImFont* base = nullptr;
    const ImFont* script = nullptr;
};

FormulaFonts formula_fonts(const render::Fonts& fonts);
FormulaFonts large_formula_fonts(const render::Fonts& fonts);
/// Fonts of formulas in a line of text in the font `words`.
FormulaFonts formula_fonts_beside(const render::Fonts& fonts, const ImFont& words);
/// Fonts of formulas in tables and pictures: the script font is also the base.
FormulaFonts small_formula_fonts(const render::Fonts& fonts);

/// Vector of the joint that a symbol stands for: it gets the colour of the vector in the 3D picture.
enum class Ink { plain, vector_i, vector_j, vector_d };

struct FormulaGlyph {
    const ImFontGlyph* glyph = nullptr;
    Point origin;  ///< of the glyph's line box, from the left end of the formula's baseline
    Ink ink = Ink::plain;
    float stretch = 1.0F;  ///< in height, of delimiters and roots around tall contents
};

/// A symbol of the formula, with its dots and scripts.
struct FormulaSymbol {
    Box box;             ///< from the left end of the baseline
    std::string source;  ///< see formula::TextSymbol
};

struct Formula {
    std::vector<FormulaGlyph> glyphs;
    std::vector<FormulaSymbol> symbols;
    std::vector<Box> rules;  ///< lines of fractions, roots and brackets, from the left end of the baseline
    float width = 0.0F;
    float ascent = 0.0F;   ///< height of the drawn parts above the baseline
    float descent = 0.0F;  ///< depth below the baseline
};

/// Size of fractions and sums.
enum class MathStyle {
    in_line,  ///< small fractions, so that they do not widen the distance of lines
    display,
};

Formula layout_formula(const math::Row& row, const FormulaFonts& fonts, MathStyle style = MathStyle::in_line);
/// A formula of the program itself.
/// @throws std::invalid_argument if it does not follow docs/mathematics.md
Formula layout_formula(std::string_view latex, const FormulaFonts& fonts);

/// @param colours  true: vectors have their colours in the picture; false: everything is drawn in `colour`
void draw_formula(
    const Canvas& canvas, Point baseline, const Formula& formula, Colour colour, bool colours = false);

/// Lets the vectors of the formula be pointed at, and marks highlighted ones. Call before drawing it.
void link_formula(const Canvas& canvas, Point baseline, const Formula& formula, int joint);

/// Lets the symbols of the formula that have a meaning be pointed at, and marks the highlighted one. Call
/// before drawing it.
/// @param scope  see SymbolView
void link_symbols(const Canvas& canvas, Point baseline, const Formula& formula, std::string_view scope = {});

}  // namespace jw::panels
