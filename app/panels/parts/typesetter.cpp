#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "app/panels/parts/formula_parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/formula/text_symbols.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/symbols.hpp"
#include "render/fonts/math_alphabets.hpp"

namespace jw::panels {

namespace {

// in parts of the font size, as in books set with Latin Modern
constexpr float kRaise = 0.30F;
constexpr float kLower = 0.13F;
constexpr float kAfterScript = 0.05F;
constexpr float kAxis = 0.26F;  ///< height of the minus sign
constexpr float kThin = 0.14F;
constexpr float kMedium = 0.22F;
constexpr float kThick = 0.28F;

constexpr char32_t kPrime = U'′';

bool is_latin(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }
bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_capital(char32_t c) { return (c >= U'A' && c <= U'Z') || (c >= 0x0391 && c <= 0x03A9); }

/// Bold form of a character: italic for vectors; upright for matrices, Φ and 0.
char32_t bold(char32_t c) {
    return is_capital(c) || is_digit(c) ? render::math_bold(c) : render::math_bold_italic(c);
}

char32_t styled(char32_t c, const math::Sign& sign) {
    if (sign.kind == math::SignKind::number) { return sign.alphabet == math::Alphabet::bold ? bold(c) : c; }
    if (sign.kind != math::SignKind::letter) { return c; }
    switch (sign.alphabet) {
        case math::Alphabet::italic: return is_capital(c) && !is_latin(c) ? c : render::math_italic(c);
        case math::Alphabet::bold: return bold(c);
        case math::Alphabet::upright: break;
    }
    return c;
}

char32_t mark_of(math::AccentKind kind) {
    switch (kind) {
        case math::AccentKind::tilde: return 0x02DC;
        case math::AccentKind::dot: return 0x02D9;
        case math::AccentKind::two_dots: return 0x00A8;
        case math::AccentKind::hat: return 0x02C6;
        case math::AccentKind::arrow: return 0x2192;
        case math::AccentKind::bar: break;
    }
    return 0x00AF;
}

/// The letter of a symbol, below its accents; nullptr if there is none.
const math::Sign* letter_of(const math::Node& node) {
    if (const auto* const sign = std::get_if<math::Sign>(&node.nucleus)) {
        return sign->kind == math::SignKind::letter ? sign : nullptr;
    }
    const auto* const accent = std::get_if<math::Accent>(&node.nucleus);
    return accent != nullptr && accent->inner.size() == 1 ? letter_of(accent->inner[0]) : nullptr;
}

/// Colour of a symbol; only bold letters are vectors.
Ink ink_of(const math::Node& node) {
    const math::Sign* const letter = letter_of(node);
    if (letter == nullptr || letter->alphabet != math::Alphabet::bold) { return Ink::plain; }
    const char32_t c = from_utf8(letter->utf8)[0];
    if (c == U'd') { return Ink::vector_d; }
    if (is_capital(c) || is_digit(c) || c == U'r') { return Ink::plain; }
    if (node.below.size() != 1) { return Ink::plain; }
    if (is_sign(node.below[0], "i")) { return Ink::vector_i; }
    return is_sign(node.below[0], "j") ? Ink::vector_j : Ink::plain;
}

bool is_space(const math::Node& node) { return std::holds_alternative<math::Space>(node.nucleus); }

/// True if a minus after `node` is a sign, not an operation.
bool awaits_operand(const math::Node& node) {
    using enum math::SignKind;
    return is_kind(node, relation) || is_kind(node, operation) || is_kind(node, opening) ||
           is_kind(node, punctuation) || is_space(node);
}

/// True for a symbol that would touch its neighbour without a space.
bool is_marked(const math::Node& node) {
    if (is_kind(node, math::SignKind::number) && node.above.empty()) { return false; }
    return !node.below.empty() || !node.above.empty() || letter_of(node) == nullptr ||
           std::holds_alternative<math::Accent>(node.nucleus) ||
           letter_of(node)->alphabet == math::Alphabet::bold;
}

/// Spaces between neighbours, in parts of the font size.
class Spacing {
public:
    /// @param before  the node before `left`, or nullptr
    float between(const math::Node* before, const math::Node& left, const math::Node& right) {
        using enum math::SignKind;
        if (is_kind(left, fence)) { inside_ = !inside_; }
        if (is_space(left) || is_space(right)) { return 0.0F; }
        if (is_kind(left, relation) || is_kind(right, relation)) { return kThick; }
        if (is_kind(left, punctuation)) { return kThin; }
        if (is_kind(right, operation)) { return awaits_operand(left) ? 0.0F : kMedium; }
        if (is_kind(left, operation)) {
            return before == nullptr || awaits_operand(*before) ? 0.0F : kMedium;
        }
        if (is_kind(right, function)) { return is_kind(left, opening) ? 0.0F : kThin; }
        if (is_kind(left, function) || is_kind(left, large)) {
            return is_kind(right, opening) ? 0.0F : kThin;
        }
        if (is_kind(left, opening) || is_kind(right, closing) || is_kind(right, opening)) { return 0.0F; }
        if (is_kind(right, punctuation) || is_kind(left, ordinary) || is_kind(right, ordinary)) {
            return 0.0F;
        }
        if (is_kind(left, fence)) { return inside_ ? 0.0F : kThin; }
        if (is_kind(right, fence)) { return inside_ ? 0.0F : kThin; }
        if (is_kind(left, number)) { return 0.0F; }
        return is_marked(left) || is_marked(right) ? kThin : 0.0F;
    }

private:
    bool inside_ = false;
};

/// Lays out rows of nodes in one of two sizes.
class Typesetter {
public:
    Typesetter(const FormulaFonts& fonts, bool display, bool small = false)
        : fonts_(fonts), display_(display), small_(small) {}

    Formula row(const math::Row& nodes) const {
        Formula line;
        float pen = 0.0F;
        Spacing spacing;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            if (k > 0) {
                const float gap = spacing.between(k > 1 ? &nodes[k - 2] : nullptr, nodes[k - 1], nodes[k]);
                pen += (small_ ? 0.5F * gap : gap) * em();
            }
            const Formula laid = node(nodes[k]);
            put_into(line, laid, {pen, 0.0F});
            pen += laid.width;
        }
        line.width = pen;
        return line;
    }

private:
    const ImFont& font() const { return small_ ? *fonts_.script : *fonts_.base; }
    float em() const { return font().FontSize; }
    float axis() const { return kAxis * em(); }
    Typesetter smaller() const { return {fonts_, false, true}; }
    /// Typesetter for the parts of a fraction.
    Typesetter part() const { return {fonts_, false, small_ || !display_}; }

    Formula node(const math::Node& node) const {
        Formula laid = with_scripts(node);
        if (const auto symbol = formula::text_symbol_of(node)) {
            const Box box{0.0F, -laid.ascent, laid.width, laid.ascent + laid.descent};
            laid.symbols = {{box, symbol->source}};
        }
        return laid;
    }

    Formula with_scripts(const math::Node& node) const {
        const Ink ink = ink_of(node);
        Formula laid = nucleus(node, ink);
        if (node.below.empty() && node.above.empty()) { return laid; }
        const float start = laid.width;
        const float tall = std::max(0.0F, laid.ascent - 1.1F * em());
        const float deep = std::max(0.0F, laid.descent - 0.45F * em());
        const float raise = std::round(kRaise * em() + tall);
        const float lower =
            std::round(kLower * em() + deep) + room_between(node, raise, kLower * em() + deep);
        const float below = put_script(laid, node.below, start, lower, ink);
        const float above = put_superscript(laid, node.above, start, -raise, ink);
        laid.width = std::max(below, above) + kAfterScript * em();
        return laid;
    }

    /// Distance by which a subscript is lowered so that it does not overlap the superscript: scripts of small
    /// formulas are hardly smaller than their letters.
    float room_between(const math::Node& node, float raise, float lower) const {
        if (node.below.empty() || node.above.empty()) { return 0.0F; }
        const float foot = smaller().row(node.above).descent - raise;
        const float top = lower - smaller().row(node.below).ascent;
        return std::max(0.0F, std::ceil(foot - top));
    }

    float put_superscript(Formula& laid, const math::Row& above, float x, float down, Ink ink) const {
        std::size_t primes = 0;
        while (primes < above.size() && is_sign(above[primes], "′")) { ++primes; }
        // a prime is already high in its font: it is put beside its letter at full size
        for (std::size_t k = 0; k < primes; ++k) {
            const Formula prime = glyph_formula(font(), kPrime, ink);
            put_into(laid, prime, {x, down + std::round(kRaise * em())});
            x += prime.width;
        }
        const math::Row rest(above.begin() + static_cast<std::ptrdiff_t>(primes), above.end());
        return put_script(laid, rest, x, down, ink);
    }

    float put_script(Formula& laid, const math::Row& row, float x, float down, Ink ink) const {
        if (row.empty()) { return x; }
        Formula script = smaller().row(row);
        for (FormulaGlyph& glyph : script.glyphs) { glyph.ink = ink; }
        put_into(laid, script, {x, down});
        return x + script.width;
    }

    Formula nucleus(const math::Node& node, Ink ink) const {
        return std::visit(
            Overloaded{
                [&](const math::Sign& sign) { return letters(from_utf8(sign.utf8), &sign, ink); },
                [&](const math::Words& words) { return letters(from_utf8(words.utf8), nullptr, ink); },
                [&](const math::Space& space) {
                    Formula gap;
                    gap.width = static_cast<float>(space.em) * em();
                    return gap;
                },
                [&](const math::Fraction& f) {
                    return fraction_formula(part().row(f.above), part().row(f.below), em(), axis());
                },
                [&](const math::Root& root) { return root_formula(font(), row(root.inner)); },
                [&](const math::Accent& accent) { return accented(accent, ink); },
                [&](const math::Group& group) {
                    return delimited(group.open, row(group.inner), group.close);
                },
                [&](const math::Matrix& matrix) { return laid_matrix(matrix); },
            },
            node.nucleus);
    }

    Formula letters(const std::u32string& text, const math::Sign* sign, Ink ink) const {
        Formula word;
        for (const char32_t c : text) {
            put_into(
                word, glyph_formula(font(), sign == nullptr ? c : styled(c, *sign), ink), {word.width, 0.0F});
        }
        return word;
    }

    Formula accented(const math::Accent& accent, Ink ink) const {
        Formula inner = row(accent.inner);
        for (FormulaGlyph& glyph : inner.glyphs) { glyph.ink = ink; }
        if (accent.kind == math::AccentKind::bar) { return overlined_formula(inner, em()); }
        const math::Sign* const letter = accent.inner.size() == 1 ? letter_of(accent.inner[0]) : nullptr;
        const bool slanted = letter != nullptr && letter->alphabet != math::Alphabet::upright;
        return accent_formula(font(), inner, mark_of(accent.kind), slanted, ink);
    }

    /// `inner` between delimiters, which reach as far above the axis as below it.
    Formula delimited(std::string_view open, const Formula& inner, std::string_view close) const {
        if (open.empty() && close.empty()) { return inner; }
        const float half = std::max(inner.ascent - axis(), inner.descent + axis()) + 0.05F * em();
        Formula whole;
        for (const Formula& piece :
             {delimiter_formula(font(), open, half + axis(), half - axis()), inner,
              delimiter_formula(font(), close, half + axis(), half - axis())}) {
            put_into(whole, piece, {whole.width, 0.0F});
        }
        return whole;
    }

    Formula laid_matrix(const math::Matrix& matrix) const {
        const Typesetter cells(fonts_, false, small_);
        std::vector<std::vector<Formula>> rows;
        for (const auto& row : matrix.rows) {
            rows.emplace_back();
            for (const math::Row& cell : row) { rows.back().push_back(cells.row(cell)); }
        }
        const math::Environment& environment = math::environment_of(matrix.kind);
        const bool cases = matrix.kind == math::MatrixKind::cases;
        return delimited(environment.open, matrix_formula(rows, em(), axis(), cases), environment.close);
    }

    FormulaFonts fonts_;
    bool display_;
    bool small_;
};

}  // namespace

Formula layout_formula(const math::Row& row, const FormulaFonts& fonts, MathStyle style) {
    return Typesetter(fonts, style == MathStyle::display).row(row);
}

Formula layout_formula(std::string_view latex, const FormulaFonts& fonts) {
    return layout_formula(math::own_math(latex), fonts);
}

}  // namespace jw::panels
