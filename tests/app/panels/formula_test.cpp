#include "app/panels/parts/formula.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "app/panels/parts/rich_text.hpp"
#include "lessons/math/read_math.hpp"
#include "render/fonts/math_alphabets.hpp"
#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

Formula laid_out(const Surface& surface, const char* markup) {
    return layout_formula(markup, formula_fonts(surface.fonts()));
}

char32_t letter(const FormulaGlyph& glyph) { return static_cast<char32_t>(glyph.glyph->Codepoint); }

float left(const FormulaGlyph& glyph) { return glyph.origin.x + glyph.glyph->X0; }
float right(const FormulaGlyph& glyph) { return glyph.origin.x + glyph.glyph->X1; }
float top(const FormulaGlyph& glyph) { return glyph.origin.y + glyph.glyph->Y0; }
float bottom(const FormulaGlyph& glyph) { return glyph.origin.y + glyph.glyph->Y1; }

}  // namespace

TEST_CASE("widths of letters side by side add up", "[panels][formula]") {
    const Surface surface;
    const float together = laid_out(surface, "xyz").width;
    const float apart =
        laid_out(surface, "x").width + laid_out(surface, "y").width + laid_out(surface, "z").width;
    // sums of the same float numbers in another order
    CHECK(together == Approx(apart).epsilon(1e-5));
}

TEST_CASE("a tilde stands above its letter and over it", "[panels][formula]") {
    const Surface surface;
    const Formula formula = laid_out(
        surface,
        GENERATE(
            "\\tilde{\\mathbf{s}}", "\\dot{\\mathbf{r}}", "\\ddot{\\mathbf{r}}", "\\tilde{\\mathbf{A}}"));
    REQUIRE(formula.glyphs.size() == 2);
    const auto& [nucleus, accent] = std::tie(formula.glyphs[0], formula.glyphs[1]);
    CHECK(bottom(accent) <= top(nucleus));
    CHECK(top(nucleus) - bottom(accent) < 4.0F);  // pixels, at 720
    CHECK(left(accent) < right(nucleus));
    CHECK(right(accent) > left(nucleus));
    CHECK(formula.ascent >= -top(accent));
}

TEST_CASE(
    "scripts stand right of their letter, one lower, one higher, both at the same x", "[panels][formula]") {
    const Surface surface;
    const Formula formula = laid_out(surface, "\\mathbf{s}_j^P");
    REQUIRE(formula.glyphs.size() == 3);
    const auto& [nucleus, below, above] = std::tie(formula.glyphs[0], formula.glyphs[1], formula.glyphs[2]);
    CHECK(letter(below) == render::math_italic(U'j'));
    CHECK(letter(above) == render::math_italic(U'P'));
    CHECK(below.origin.x == above.origin.x);
    CHECK(below.origin.x >= nucleus.origin.x + nucleus.glyph->AdvanceX - 0.01F);
    CHECK(bottom(below) > bottom(nucleus));
    CHECK(top(above) < top(nucleus));
    CHECK(bottom(above) < bottom(below));
}

TEST_CASE(
    "single letters are italic, words, names and transposes upright, marked ones bold", "[panels][formula]") {
    const Surface surface;
    CHECK(letter(laid_out(surface, "\\theta").glyphs[0]) == render::math_italic(U'θ'));
    CHECK(letter(laid_out(surface, "\\cos").glyphs[0]) == U'c');
    CHECK(letter(laid_out(surface, "x^{(p1)}").glyphs[2]) == U'p');
    CHECK(letter(laid_out(surface, "\\mathbf{s}").glyphs[0]) == render::math_bold_italic(U's'));
    CHECK(letter(laid_out(surface, "\\mathbf{A}").glyphs[0]) == render::math_bold(U'A'));
    CHECK(letter(laid_out(surface, "\\boldsymbol{\\Phi}").glyphs[0]) == render::math_bold(U'Φ'));
    CHECK(letter(laid_out(surface, "\\mathbf{0}").glyphs[0]) == render::math_bold(U'0'));
    CHECK(letter(laid_out(surface, "\\mathbf{s}^T").glyphs[1]) == U'T');
    CHECK(letter(laid_out(surface, "\\boldsymbol{\\Phi}^{(s,3)}").glyphs[2]) == U's');
}

TEST_CASE("vectors have the colour of their body", "[panels][formula]") {
    const Surface surface;
    CHECK(laid_out(surface, "\\mathbf{s}_i").glyphs[0].ink == Ink::vector_i);
    CHECK(laid_out(surface, "\\mathbf{u}_j^T").glyphs[0].ink == Ink::vector_j);
    CHECK(laid_out(surface, "\\mathbf{d}").glyphs[0].ink == Ink::vector_d);
    CHECK(laid_out(surface, "\\mathbf{r}_i").glyphs[0].ink == Ink::plain);
    CHECK(laid_out(surface, "\\mathbf{A}_i").glyphs[0].ink == Ink::plain);
}

TEST_CASE("a formula that cannot be read is drawn as far as it goes", "[panels][formula]") {
    const Surface surface;
    const char* const source = GENERATE(
        "", "\\mathbf", "\\tilde", "_", "x^", "\\mathbf{s}_", "s^{ab", "\\frac{1}", "\\begin{x}", "\xCE");
    CAPTURE(source);
    const math::Reading reading = math::read_math(source);
    CHECK(layout_formula(reading.row, formula_fonts(surface.fonts())).width >= 0.0F);
}

TEST_CASE("the line of a fraction lies between its parts", "[panels][formula]") {
    const Surface surface;
    const MathStyle style = GENERATE(MathStyle::in_line, MathStyle::display);
    const math::Row row = math::own_math("\\frac{a}{b}");
    const Formula formula = layout_formula(row, formula_fonts(surface.fonts()), style);
    REQUIRE(formula.glyphs.size() == 2);
    REQUIRE(formula.rules.size() == 1);
    CHECK(bottom(formula.glyphs[0]) < formula.rules[0].y);
    CHECK(top(formula.glyphs[1]) > formula.rules[0].bottom());
    CHECK(formula.ascent >= -top(formula.glyphs[0]));
}

TEST_CASE("a matrix has its entries in rows and columns, within its brackets", "[panels][formula]") {
    const Surface surface;
    const Formula formula = laid_out(surface, "\\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}");
    REQUIRE(formula.glyphs.size() == 4);
    const auto& g = formula.glyphs;
    CHECK(right(g[0]) < left(g[1]));
    CHECK(right(g[2]) < left(g[3]));
    CHECK(bottom(g[0]) < top(g[2]));
    REQUIRE(formula.rules.size() == 6);  // three lines a bracket
    for (const FormulaGlyph& glyph : g) {
        CHECK(left(glyph) > formula.rules[0].right());
        CHECK(right(glyph) < formula.rules[3].x);
        CHECK(top(glyph) >= formula.rules[0].y);
        CHECK(bottom(glyph) <= formula.rules[0].bottom());
    }
}

TEST_CASE("parentheses grow with what they hold", "[panels][formula]") {
    const Surface surface;
    const Formula flat = laid_out(surface, "\\left(a\\right)");
    const Formula tall = laid_out(surface, "\\left(\\begin{matrix} a \\\\ b \\\\ c \\end{matrix}\\right)");
    CHECK(flat.glyphs[0].stretch == 1.0F);
    CHECK(tall.glyphs[0].stretch > 2.0F);
    CHECK(tall.ascent + tall.descent > 2.0F * (flat.ascent + flat.descent));
}

TEST_CASE("ascent and descent hold all that is inked", "[panels][formula]") {
    Surface surface;
    const Formula formula = laid_out(
        surface,
        "\\boldsymbol{\\Phi}^{(\\theta,1)} \\equiv (\\mathbf{u}_i \\times \\mathbf{u}_j)^T "
        "\\tilde{\\mathbf{s}}_i \\cos \\theta - \\mathbf{u}_i^T \\mathbf{u}_j \\sin \\theta = 0");
    draw_formula(surface.canvas(), {100.0F, 200.0F}, formula, render::palette::kInk);
    const Box box{
        99.0F, 200.0F - formula.ascent - 0.01F, formula.width + 2.0F,
        formula.ascent + formula.descent + 0.02F};
    CHECK(box.contains(surface.drawn()));
}

TEST_CASE("A letter of a formula is as high as one of the words beside it", "[panels][formula]") {
    const Surface surface;
    const render::Fonts& fonts = surface.fonts();
    const auto height = [](const ImFontGlyph& x) { return x.Y1 - x.Y0; };
    for (const ImFont* const words : {fonts.normal, fonts.small}) {
        const Formula formula = layout_formula("x", formula_fonts_beside(fonts, *words));
        // both are rounded to whole pixels
        CHECK(std::abs(height(*formula.glyphs.front().glyph) - height(*words->FindGlyph('x'))) <= 1.0F);
    }
}

TEST_CASE("A line feed begins a line, with formulas and without", "[panels][formula]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    CHECK(layout_rich(surface.fonts(), font, "one $x$ two\nthree $y$", 900.0F).lines.size() == 2);
    CHECK(layout_rich(surface.fonts(), font, "one $x$\n$y$\nthree", 900.0F).lines.size() == 3);
    CHECK(layout_rich(surface.fonts(), font, "one $x$ two three", 900.0F).lines.size() == 1);
}

}  // namespace jw::panels::test
