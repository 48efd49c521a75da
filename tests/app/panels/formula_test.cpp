#include "app/panels/parts/formula.hpp"

#include <catch2/catch.hpp>

#include "render/math_alphabets.hpp"
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

TEST_CASE("widths of formulas side by side add up", "[panels][formula]") {
    const Surface surface;
    const float together = laid_out(surface, "~s_i@s_j=@0").width;
    const float apart = laid_out(surface, "~s_i").width + laid_out(surface, "@s_j").width +
                        laid_out(surface, "=").width + laid_out(surface, "@0").width;
    // sums of the same float numbers in another order
    CHECK(together == Approx(apart).epsilon(1e-5));
}

TEST_CASE("a tilde stands above its letter and over it", "[panels][formula]") {
    const Surface surface;
    const Formula formula = laid_out(surface, GENERATE("~s", "˙r", "¨r", "~A"));
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
    const Formula formula = laid_out(surface, "@s_j^P");
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
    CHECK(letter(laid_out(surface, "θ").glyphs[0]) == render::math_italic(U'θ'));
    CHECK(letter(laid_out(surface, "cos").glyphs[0]) == U'c');
    CHECK(letter(laid_out(surface, "p1").glyphs[0]) == U'p');
    CHECK(letter(laid_out(surface, "@s").glyphs[0]) == render::math_bold_italic(U's'));
    CHECK(letter(laid_out(surface, "@A").glyphs[0]) == render::math_bold(U'A'));
    CHECK(letter(laid_out(surface, "@Φ").glyphs[0]) == render::math_bold(U'Φ'));
    CHECK(letter(laid_out(surface, "@0").glyphs[0]) == render::math_bold(U'0'));
    CHECK(letter(laid_out(surface, "@s^T").glyphs[1]) == U'T');
    CHECK(letter(laid_out(surface, "@Φ^{(s,3)}").glyphs[2]) == U's');
}

TEST_CASE("vectors have the colour of their body", "[panels][formula]") {
    const Surface surface;
    CHECK(laid_out(surface, "@s_i").glyphs[0].ink == Ink::vector_i);
    CHECK(laid_out(surface, "@u_j^T").glyphs[0].ink == Ink::vector_j);
    CHECK(laid_out(surface, "@d").glyphs[0].ink == Ink::vector_d);
    CHECK(laid_out(surface, "@r_i").glyphs[0].ink == Ink::plain);
    CHECK(laid_out(surface, "@A_i").glyphs[0].ink == Ink::plain);
}

TEST_CASE("unfinished markup is drawn as far as it goes", "[panels][formula]") {
    const Surface surface;
    const char* const markup = GENERATE("", "@", "~", "_", "^", "@s_", "@s^{ab", "^{", "′", "\xCE");
    CAPTURE(markup);
    CHECK(laid_out(surface, markup).width >= 0.0F);
}

TEST_CASE("ascent and descent hold all that is inked", "[panels][formula]") {
    Surface surface;
    const Formula formula =
        laid_out(surface, "@Φ^{(θ,1)} ≡ (@u_i × @u_j)^T ~s_i cos θ − @u_i^T @u_j sin θ = 0");
    draw_formula(surface.canvas(), {100.0F, 200.0F}, formula, render::palette::kInk);
    const Box box{
        99.0F, 200.0F - formula.ascent - 0.01F, formula.width + 2.0F,
        formula.ascent + formula.descent + 0.02F};
    CHECK(box.contains(surface.drawn()));
}

}  // namespace jw::panels::test
