#include "app/panels/parts/formula.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "app/panels/parts/text.hpp"
#include "app/panels/parts/theme.hpp"
#include "render/math_alphabets.hpp"

namespace jw::panels {

namespace {

// heights in parts of the font size, as in books set with Latin Modern
constexpr float kRaise = 0.30F;
constexpr float kLower = 0.13F;
constexpr float kAfterScript = 0.05F;
constexpr float kAccentGap = 0.02F;
constexpr float kThinner = 0.12F;  ///< a thin space is narrower than a space by this

constexpr char32_t kTilde = 0x02DC;
constexpr char32_t kDot = 0x02D9;
constexpr char32_t kTwoDots = 0x00A8;
constexpr char32_t kPrime = U'′';

bool is_latin(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }
bool is_greek(char32_t c) { return (c >= 0x0391 && c <= 0x03C9) || c == 0x03D1 || c == 0x03D5; }
bool is_letter(char32_t c) { return is_latin(c) || is_greek(c); }
bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_capital(char32_t c) { return (c >= U'A' && c <= U'Z') || (c >= 0x0391 && c <= 0x03A9); }

/// Vectors are bold italic, matrices, Φ and 0 bold upright.
char32_t bold(char32_t c) {
    return is_capital(c) || is_digit(c) ? render::math_bold(c) : render::math_bold_italic(c);
}

/// Letters of words and of names like p1 are upright, single ones italic; T is the transpose.
char32_t styled(std::u32string_view text, std::size_t k) {
    const auto joins = [](char32_t c) { return is_letter(c) || is_digit(c); };
    const bool joined = (k > 0 && joins(text[k - 1])) || (k + 1 < text.size() && joins(text[k + 1]));
    return is_letter(text[k]) && !joined ? render::math_italic(text[k]) : text[k];
}

Ink ink_of(char32_t letter, std::u32string_view subscript) {
    if (letter == U'd') { return Ink::vector_d; }
    if (is_capital(letter) || is_digit(letter) || letter == U'r') { return Ink::plain; }
    if (subscript == U"i") { return Ink::vector_i; }
    return subscript == U"j" ? Ink::vector_j : Ink::plain;
}

/// Reads markup from left to right and puts glyphs side by side.
class Typesetter {
public:
    Typesetter(std::u32string_view markup, const FormulaFonts& fonts) : markup_(markup), fonts_(fonts) {}

    Formula run() {
        while (at_ < markup_.size()) { set_atom(); }
        formula_.width = pen_;
        return std::move(formula_);
    }

private:
    struct Scripts {
        std::u32string below;
        std::u32string above;
        std::size_t end = 0;  ///< of the markup read
    };

    void set_atom() {
        const char32_t mark = markup_[at_];
        const bool accent = mark == U'~' || mark == kDot || mark == kTwoDots;
        const bool marked = (mark == U'@' || accent) && at_ + 1 < markup_.size();
        const std::size_t nucleus = marked ? at_ + 1 : at_;
        const char32_t letter = markup_[nucleus];
        const Scripts scripts = read_scripts(nucleus + 1);

        const float left = pen_;
        const Ink ink = marked ? ink_of(letter, scripts.below) : Ink::plain;
        put(fonts_.base, marked ? bold(letter) : styled(markup_, nucleus), 0.0F, ink);
        if (letter == U' ' && !beside_operator(nucleus)) { pen_ -= kThinner * fonts_.base->FontSize; }
        if (accent) { put_accent(mark == U'~' ? kTilde : mark, left, ink); }
        put_scripts(scripts, ink);
        at_ = scripts.end;
    }

    /// Around = and + spaces are wide, between factors thin.
    bool beside_operator(std::size_t at) const {
        constexpr std::u32string_view operators = U"=≡+−×, ";
        const auto is_one = [&](std::size_t k) {
            return k < markup_.size() && operators.find(markup_[k]) != std::u32string_view::npos;
        };
        return is_one(at - 1) || is_one(at + 1);
    }

    Scripts read_scripts(std::size_t at) const {
        Scripts scripts;
        for (bool more = true; more && at < markup_.size();) {
            if (markup_[at] == kPrime) {
                scripts.above += kPrime;
                ++at;
            } else if ((markup_[at] == U'_' || markup_[at] == U'^') && at + 1 < markup_.size()) {
                std::u32string& target = markup_[at] == U'_' ? scripts.below : scripts.above;
                at = read_group(at + 1, target);
            } else {
                more = false;
            }
        }
        scripts.end = at;
        return scripts;
    }

    /// One character or {group}; an open group reaches to the end.
    std::size_t read_group(std::size_t at, std::u32string& target) const {
        if (markup_[at] != U'{') {
            target += markup_[at];
            return at + 1;
        }
        const std::size_t end = std::min(markup_.find(U'}', at), markup_.size());
        target += markup_.substr(at + 1, end - at - 1);
        return std::min(end + 1, markup_.size());
    }

    void put_scripts(const Scripts& scripts, Ink ink) {
        const float size = fonts_.base->FontSize;
        const float start = pen_;
        put_script(scripts.below, kLower * size, ink);
        const float below = pen_;
        pen_ = start;
        put_script(scripts.above, -kRaise * size, ink);
        pen_ = std::max(pen_, below);
        if (pen_ > start) { pen_ += kAfterScript * size; }
    }

    void put_script(std::u32string_view text, float down, Ink ink) {
        const bool upright = text.starts_with(U"(") || text == U"T";
        for (std::size_t k = 0; k < text.size(); ++k) {
            // a prime is high already: it stands beside its letter at full size
            const bool prime = text[k] == kPrime;
            const char32_t c = upright ? text[k] : styled(text, k);
            put(prime ? fonts_.base : fonts_.script, c, prime ? 0.0F : std::round(down), ink);
        }
    }

    void put_accent(char32_t accent, float left, Ink ink) {
        const FormulaGlyph letter = formula_.glyphs.back();
        const ImFontGlyph& mark = *fonts_.base->FindGlyph(static_cast<ImWchar>(accent));
        const float middle = left + 0.5F * (letter.glyph->X0 + letter.glyph->X1);
        const float gap = kAccentGap * fonts_.base->FontSize;
        const float top_of_letter = letter.origin.y + letter.glyph->Y0;
        // slanted letters carry it a little to the right of their middle
        const float slant = 0.06F * fonts_.base->FontSize;
        const Point origin{
            middle + slant - 0.5F * (mark.X0 + mark.X1), std::round(top_of_letter - gap - mark.Y1)};
        add(mark, origin, ink);
    }

    void put(const ImFont* font, char32_t c, float down, Ink ink) {
        const ImFontGlyph& glyph = *font->FindGlyph(static_cast<ImWchar>(c));
        add(glyph, {pen_, down - std::round(font->Ascent)}, ink);
        pen_ += glyph.AdvanceX;
    }

    void add(const ImFontGlyph& glyph, Point origin, Ink ink) {
        formula_.glyphs.push_back({&glyph, origin, ink});
        if (glyph.Visible == 0) { return; }
        formula_.ascent = std::max(formula_.ascent, -(origin.y + glyph.Y0));
        formula_.descent = std::max(formula_.descent, origin.y + glyph.Y1);
    }

    std::u32string_view markup_;
    FormulaFonts fonts_;
    Formula formula_;
    std::size_t at_ = 0;
    float pen_ = 0.0F;
};

Colour colour_of(Ink ink, Colour plain) {
    switch (ink) {
        case Ink::vector_i: return render::palette::kVectorI;
        case Ink::vector_j: return render::palette::kVectorJ;
        case Ink::vector_d: return render::palette::kVectorD;
        case Ink::plain: break;
    }
    return plain;
}

/// Which vector of the joint a symbol stands for.
Pointable pointable_of(Ink ink, int joint) {
    switch (ink) {
        case Ink::vector_i: return Pointable::vector(joint, Pointable::kVectorI);
        case Ink::vector_j: return Pointable::vector(joint, Pointable::kVectorJ);
        case Ink::vector_d: return Pointable::vector(joint, Pointable::kVectorD);
        case Ink::plain: break;
    }
    return {};
}

}  // namespace

FormulaFonts formula_fonts(const render::Fonts& fonts) { return {fonts.formula, fonts.formula_script}; }

FormulaFonts large_formula_fonts(const render::Fonts& fonts) {
    return {fonts.formula_large, fonts.formula_large_script};
}

FormulaFonts small_formula_fonts(const render::Fonts& fonts) {
    return {fonts.formula_script, fonts.formula_script};
}

Formula layout_formula(std::string_view markup, const FormulaFonts& fonts) {
    const std::u32string points = from_utf8(markup);
    return Typesetter(points, fonts).run();
}

void draw_formula(const Canvas& canvas, Point baseline, const Formula& formula, Colour colour, bool colours) {
    for (const FormulaGlyph& g : formula.glyphs) {
        const Point at{baseline.x + g.origin.x, std::round(baseline.y) + g.origin.y};
        canvas.glyph(at, *g.glyph, colours ? colour_of(g.ink, colour) : colour);
    }
}

void link_formula(const Canvas& canvas, Point baseline, const Formula& formula, int joint) {
    // glyphs of one symbol follow each other: letter, accent, scripts
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
        canvas.spot(box, link);
        if (!canvas.lit(link)) { continue; }
        canvas.fill(box, theme::kSubject, canvas.px(3.0F));
        canvas.fill({box.x, box.bottom() - air, box.width, air}, theme::kSubjectMark);
    }
}

}  // namespace jw::panels
