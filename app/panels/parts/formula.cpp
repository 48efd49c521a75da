#include "app/panels/parts/formula.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

Colour colour_of(Ink ink, Colour plain) {
    switch (ink) {
        case Ink::vector_i: return render::palette::kVectorI;
        case Ink::vector_j: return render::palette::kVectorJ;
        case Ink::vector_d: return render::palette::kVectorD;
        case Ink::plain: break;
    }
    return plain;
}

/// The vector of the joint that a symbol stands for.
Pointable pointable_of(Ink ink, int joint) {
    switch (ink) {
        case Ink::vector_i: return Pointable::vector(joint, Pointable::kVectorI);
        case Ink::vector_j: return Pointable::vector(joint, Pointable::kVectorJ);
        case Ink::vector_d: return Pointable::vector(joint, Pointable::kVectorD);
        case Ink::plain: break;
    }
    return {};
}

/// Registers a symbol of a formula, and marks it with a line at its foot if it is highlighted.
void link_box(const Canvas& canvas, const Box& box, const Pointable& link) {
    canvas.spot(box, link);
    if (!canvas.lit(link)) { return; }
    const float air = canvas.px(2.0F);
    canvas.fill(box, theme::kSubject, canvas.px(3.0F));
    canvas.fill({box.x, box.bottom() - air, box.width, air}, theme::kSubjectMark);
}

}  // namespace

FormulaFonts formula_fonts(const render::Fonts& fonts) { return {fonts.formula, fonts.formula_script}; }

FormulaFonts large_formula_fonts(const render::Fonts& fonts) {
    return {fonts.formula_large, fonts.formula_large_script};
}

FormulaFonts formula_fonts_beside(const render::Fonts& fonts, const ImFont& words) {
    const ImFont* const base = &words == fonts.small ? fonts.formula_script : fonts.formula_words;
    return {base, fonts.formula_words_script};
}

FormulaFonts small_formula_fonts(const render::Fonts& fonts) {
    return {fonts.formula_script, fonts.formula_script};
}

void draw_formula(const Canvas& canvas, Point baseline, const Formula& formula, Colour colour, bool colours) {
    for (const FormulaGlyph& g : formula.glyphs) {
        const Point at{baseline.x + g.origin.x, std::round(baseline.y) + g.origin.y};
        canvas.glyph(at, *g.glyph, colours ? colour_of(g.ink, colour) : colour, g.stretch);
    }
    for (const Box& rule : formula.rules) {
        const float y = std::round(baseline.y) + rule.y;
        canvas.fill({baseline.x + rule.x, y, rule.width, rule.height}, colour);
    }
}

void link_formula(const Canvas& canvas, Point baseline, const Formula& formula, int joint) {
    // the glyphs of a symbol are consecutive: letter, accent, scripts
    for (std::size_t k = 0; k < formula.glyphs.size();) {
        const Ink ink = formula.glyphs[k].ink;
        const float left = formula.glyphs[k].origin.x;
        float right = left;
        for (; k < formula.glyphs.size() && formula.glyphs[k].ink == ink; ++k) {
            right = std::max(right, formula.glyphs[k].origin.x + formula.glyphs[k].glyph->X1);
        }
        const Pointable link = pointable_of(ink, joint);
        if (!link) { continue; }
        const float air = canvas.px(2.0F);
        const Box box{
            baseline.x + left - air, baseline.y - formula.ascent - air, right - left + 2.0F * air,
            formula.ascent + formula.descent + 2.0F * air};
        link_box(canvas, box, link);
    }
}

void link_symbols(const Canvas& canvas, Point baseline, const Formula& formula, std::string_view scope) {
    for (const FormulaSymbol& symbol : formula.symbols) {
        const Pointable link = canvas.symbol(scope, symbol.source);
        if (!link) { continue; }
        const float air = canvas.px(2.0F);
        const Box box{
            baseline.x + symbol.box.x - 0.5F * air, baseline.y + symbol.box.y - air, symbol.box.width + air,
            symbol.box.height + 2.0F * air};
        link_box(canvas, box, link);
    }
}

}  // namespace jw::panels
