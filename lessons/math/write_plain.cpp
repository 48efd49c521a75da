#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/numerics/variants.hpp"
#include "lessons/math/symbols.hpp"
#include "lessons/math/write_math.hpp"

namespace jw::math {

namespace {

struct Small {
    std::string_view sign;
    std::string_view small;
};

constexpr std::array kSubscripts{
    Small{"0", "₀"}, Small{"1", "₁"}, Small{"2", "₂"}, Small{"3", "₃"}, Small{"4", "₄"}, Small{"5", "₅"},
    Small{"6", "₆"}, Small{"7", "₇"}, Small{"8", "₈"}, Small{"9", "₉"}, Small{"i", "ᵢ"}, Small{"j", "ⱼ"},
    Small{"a", "ₐ"}, Small{"e", "ₑ"}, Small{"k", "ₖ"}, Small{"m", "ₘ"}, Small{"n", "ₙ"}, Small{"p", "ₚ"},
    Small{"r", "ᵣ"}, Small{"s", "ₛ"}, Small{"t", "ₜ"}, Small{"x", "ₓ"}, Small{"+", "₊"}, Small{"−", "₋"},
};
constexpr std::array kSuperscripts{
    Small{"0", "⁰"}, Small{"1", "¹"}, Small{"2", "²"}, Small{"3", "³"}, Small{"4", "⁴"}, Small{"5", "⁵"},
    Small{"6", "⁶"}, Small{"7", "⁷"}, Small{"8", "⁸"}, Small{"9", "⁹"}, Small{"T", "ᵀ"}, Small{"P", "ᴾ"},
    Small{"B", "ᴮ"}, Small{"+", "⁺"}, Small{"−", "⁻"}, Small{"′", "′"}, Small{"#", "#"},
};

/// The signs of a script as small letters; nothing if one of them has no small letter.
template <std::size_t N>
std::optional<std::string> in_small(const Row& row, const std::array<Small, N>& table) {
    std::string text;
    for (const Node& node : row) {
        const Sign* const sign = std::get_if<Sign>(&node.nucleus);
        if (sign == nullptr || !node.below.empty() || !node.above.empty()) { return std::nullopt; }
        const auto found = std::ranges::find(table, sign->utf8, &Small::sign);
        if (found == table.end()) { return std::nullopt; }
        text += found->small;
    }
    return text;
}

std::string in_parentheses(const std::string& text) { return "(" + text + ")"; }

bool is_one_sign(const Row& row) { return row.size() == 1 && std::holds_alternative<Sign>(row[0].nucleus); }

bool has_no_scripts(const Node& node) { return node.below.empty() && node.above.empty(); }

std::string as_one(const Row& row) {
    return is_one_sign(row) ? write_plain(row) : in_parentheses(write_plain(row));
}

std::string part_of_fraction(const Row& row) {
    const bool differential = row.size() == 2 && is_sign(row[0], "d");
    return differential ? write_plain(row) : as_one(row);
}

std::string subscript_of(const Row& row) {
    if (row.empty()) { return {}; }
    if (const auto small = in_small(row, kSubscripts)) { return *small; }
    // Φq, ω′y
    const bool letter = row.size() == 1 && is_kind(row[0], SignKind::letter) && has_no_scripts(row[0]);
    return (letter ? "" : "_") + as_one(row);
}

/// The nodes of a name, without spaces.
std::string name_of(const Row& row) {
    std::string name;
    for (const Node& node : row) { name += write_plain({node}); }
    return name;
}

std::string superscript_of(const Row& row) {
    if (row.empty()) { return {}; }
    if (const auto small = in_small(row, kSuperscripts)) { return *small; }
    // names such as (p1,2) and (m)
    if (is_sign(row.front(), "(") || is_sign(row.front(), "#")) { return name_of(row); }
    return "^" + as_one(row);
}

/// Puts the accent over the first character, so that it is also readable over a word.
std::string accented(const Accent& accent) {
    std::string inner = write_plain(accent.inner);
    if (!is_one_sign(accent.inner)) { inner = in_parentheses(inner); }
    return inner + std::string(accent_of(accent.kind).combining);
}

std::string matrix_text(const Matrix& matrix) {
    std::string text;
    for (const auto& row : matrix.rows) {
        if (&row != &matrix.rows.front()) { text += "; "; }
        for (const Row& cell : row) {
            if (&cell != &row.front()) { text += ", "; }
            text += write_plain(cell);
        }
    }
    const Environment& environment = environment_of(matrix.kind);
    return std::string(environment.open) + text + std::string(environment.close);
}

std::string nucleus_text(const Node& node) {
    return std::visit(
        Overloaded{
            [](const Sign& sign) { return sign.utf8; },
            [](const Words& words) { return words.utf8; },
            [](const Space& space) {
                return std::string(space.em > 0.5 ? "  " : space.em > 0.1 ? " " : "");
            },
            [](const Fraction& f) { return part_of_fraction(f.above) + "/" + part_of_fraction(f.below); },
            [](const Root& root) { return "√" + as_one(root.inner); },
            [](const Accent& accent) { return accented(accent); },
            [](const Group& group) { return group.open + write_plain(group.inner) + group.close; },
            [](const Matrix& matrix) { return matrix_text(matrix); },
        },
        node.nucleus);
}

bool is_space(const Node& node) { return std::holds_alternative<Space>(node.nucleus); }

/// The d of a differential: d/dt, dx.
bool is_differential(const Node& node) {
    const Sign* const sign = std::get_if<Sign>(&node.nucleus);
    return sign != nullptr && sign->utf8 == "d" && sign->alphabet != Alphabet::bold && has_no_scripts(node);
}

bool is_tight(const Node& node) { return is_sign(node, "/") || is_sign(node, "∂") || is_sign(node, "!"); }

/// Decides on the space between neighbours.
class Gaps {
public:
    /// @param before  the node before `left`, or nullptr
    std::string_view between(const Node* before, const Node& left, const Node& right) {
        const bool left_fence = is_kind(left, SignKind::fence);
        if (left_fence) { inside_ = !inside_; }
        if (is_space(left) || is_space(right)) { return ""; }
        if (is_kind(left, SignKind::relation) || is_kind(right, SignKind::relation)) { return " "; }
        if (is_kind(left, SignKind::punctuation)) { return " "; }
        if (is_kind(right, SignKind::operation)) { return precedes_operand(left) ? "" : " "; }
        if (is_kind(left, SignKind::operation)) {
            return before == nullptr || is_space(*before) || precedes_operand(*before) ? "" : " ";
        }
        if (is_kind(right, SignKind::punctuation)) { return ""; }
        if (is_kind(right, SignKind::closing) || is_kind(left, SignKind::opening)) { return ""; }
        if (left_fence) { return inside_ ? "" : " "; }
        if (is_kind(right, SignKind::fence)) { return inside_ ? "" : " "; }
        if (std::holds_alternative<Fraction>(left.nucleus)) { return " "; }
        if (is_kind(right, SignKind::opening) || is_tight(left) || is_tight(right)) { return ""; }
        if (is_differential(left) && is_kind(right, SignKind::letter)) { return ""; }
        return is_kind(left, SignKind::number) && left.above.empty() ? "" : " ";
    }

private:
    bool inside_ = false;
};

}  // namespace

std::string write_plain(const Row& row) {
    std::string text;
    Gaps gaps;
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (k > 0) { text += gaps.between(k > 1 ? &row[k - 2] : nullptr, row[k - 1], row[k]); }
        text += nucleus_text(row[k]);
        // a prime stands before the index: s′ᵢ
        Row above = row[k].above;
        std::string primes;
        while (!above.empty() && is_sign(above.front(), "′")) {
            primes += "′";
            above.erase(above.begin());
        }
        text += primes + subscript_of(row[k].below) + superscript_of(above);
    }
    return text;
}

}  // namespace jw::math
