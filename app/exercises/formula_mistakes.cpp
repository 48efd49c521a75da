#include <algorithm>
#include <array>
#include <string_view>

#include "app/exercises/mistakes.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/math/read_math.hpp"

namespace jw {

namespace {

using math::Node;
using math::Row;
using math::Sign;
using math::SignKind;
using Alterations = std::vector<Altered>;

Node sign_node(const char* utf8, SignKind kind) {
    Node node;
    node.nucleus = Sign{utf8, kind, math::Alphabet::italic};
    return node;
}

/// Once at each place, and everywhere at once.
Alterations once_and_everywhere(const Row& right, const Change& change) {
    Alterations all = changed_once(right, change);
    std::ranges::move(changed_everywhere(right, change), std::back_inserter(all));
    return all;
}

bool is_letter(const Letter& letter, std::initializer_list<std::string_view> letters) {
    return letter.sign != nullptr && std::ranges::find(letters, letter.sign->utf8) != letters.end();
}

bool erase_sign(Row& row, const char* utf8) {
    const auto found = std::ranges::find_if(row, [&](const Node& n) { return is_sign(n, utf8); });
    if (found == row.end()) { return false; }
    row.erase(found);
    return true;
}

Alterations wrong_sign(const Row& right) {
    Altered altered{{sign_node("−", SignKind::operation)}, "the answer"};
    Node group;
    group.nucleus = math::Group{"", "", right};
    altered.row.push_back(std::move(group));
    return {altered};
}

Alterations sign_of_term(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        const bool minus = is_sign(row[k], "−");
        if (!minus && !is_sign(row[k], "+")) { return false; }
        std::get<Sign>(row[k].nucleus).utf8 = minus ? "+" : "−";
        return true;
    });
}

/// True if a term of a sum can end before place `k`.
bool is_sign_of_sum(const Node& node) { return is_sign(node, "+") || is_sign(node, "−"); }

/// Place behind the term that begins at `k`.
std::size_t end_of_term(const Row& row, std::size_t k) {
    int depth = 0;
    for (++k; k < row.size(); ++k) {
        if (is_kind(row[k], SignKind::opening)) { ++depth; }
        if (is_kind(row[k], SignKind::closing) && --depth < 0) { break; }
        if (depth == 0 && is_sign_of_sum(row[k])) { break; }
    }
    return k;
}

Alterations dropped_term(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        const bool begins =
            is_sign_of_sum(row[k]) || k == 0 || is_kind(row[k - 1], SignKind::opening);
        if (!begins) { return false; }
        const std::size_t end = end_of_term(row, k);
        const bool before = k > 0 && !is_kind(row[k - 1], SignKind::opening);
        const bool after = end < row.size() && !is_kind(row[end], SignKind::closing);
        if (!before && !after) { return false; }
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(k), row.begin() + static_cast<std::ptrdiff_t>(end));
        return true;
    });
}

bool exchange_index(Row& below) {
    bool changed = false;
    for (Node& node : below) {
        changed = exchange_index(node.below) || changed;
        const bool i = is_sign(node, "i");
        if (!i && !is_sign(node, "j")) { continue; }
        std::get<Sign>(node.nucleus).utf8 = i ? "j" : "i";
        changed = true;
    }
    return changed;
}

bool exchange_bodies(Row& row, std::size_t k) {
    const Letter letter = letter_of(row[k]);
    return letter.node != nullptr && exchange_index(letter.node->below);
}

Alterations exchanged_bodies(const Row& right) {
    Alterations all = changed_everywhere(right, exchange_bodies);
    return all.empty() ? changed_once(right, exchange_bodies) : all;
}

Alterations wrong_body(const Row& right) {
    return changed_everywhere(right, exchange_bodies).empty() ? Alterations{} : changed_once(right, exchange_bodies);
}

bool is_primed(const Node& node) {
    return std::ranges::any_of(node.above, [](const Node& n) { return is_sign(n, "′"); });
}

Alterations local_for_global(const Row& right) {
    return once_and_everywhere(right, [](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (!is_letter(letter, {"s", "ω", "h", "u"}) || is_primed(*letter.node)) { return false; }
        letter.node->above.insert(letter.node->above.begin(), sign_node("′", SignKind::ordinary));
        return true;
    });
}

Alterations global_for_local(const Row& right) {
    return once_and_everywhere(right, [](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        return is_letter(letter, {"s", "ω", "h", "u", "J", "n"}) && erase_sign(letter.node->above, "′");
    });
}

Alterations forgotten_matrix(const Row& right) {
    return once_and_everywhere(right, [](Row& row, std::size_t k) {
        const bool alone = row.size() < 2;
        if (alone || !is_letter(letter_of(row[k]), {"A"})) { return false; }
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(k));
        return true;
    });
}

Alterations transposed_matrix(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (!is_letter(letter, {"A", "G", "L"})) { return false; }
        if (!erase_sign(letter.node->above, "T")) {
            letter.node->above.push_back(sign_node("T", SignKind::letter));
        }
        return true;
    });
}

Alterations transposed(const Row& right) {
    Node group;
    group.nucleus = math::Group{"", "", right};
    group.above.push_back(sign_node("T", SignKind::letter));
    return {{{group}, "the answer"}};
}

Alterations exchange_letters(const Row& right, std::string_view a, std::string_view b) {
    return once_and_everywhere(right, [=](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (letter.sign == nullptr || (letter.sign->utf8 != a && letter.sign->utf8 != b)) { return false; }
        letter.sign->utf8 = letter.sign->utf8 == a ? b : a;
        return true;
    });
}

Alterations g_for_l(const Row& right) { return exchange_letters(right, "G", "L"); }

Alterations lost_factor(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        auto* const sign = std::get_if<Sign>(&row[k].nucleus);
        if (sign == nullptr || sign->kind != SignKind::number || sign->utf8 == "1" || sign->utf8 == "0") {
            return false;
        }
        sign->utf8 = "1";
        return true;
    });
}

Alterations lost_square(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        return !std::holds_alternative<math::Accent>(row[k].nucleus) && erase_sign(row[k].above, "2");
    });
}

/// An accent of that kind around a letter is taken off.
Alterations without_accent(const Row& right, math::AccentKind kind) {
    return once_and_everywhere(right, [=](Row& row, std::size_t k) {
        auto* const accent = std::get_if<math::Accent>(&row[k].nucleus);
        if (accent == nullptr || accent->inner.size() != 1) { return false; }
        if (accent->kind == kind) {
            Node inner = accent->inner.front();
            inner.below.insert(inner.below.end(), row[k].below.begin(), row[k].below.end());
            inner.above.insert(inner.above.end(), row[k].above.begin(), row[k].above.end());
            row[k] = std::move(inner);
            return true;
        }
        auto* const inner = std::get_if<math::Accent>(&accent->inner.front().nucleus);
        if (inner == nullptr || inner->kind != kind || inner->inner.size() != 1) { return false; }
        Row under = inner->inner;
        accent->inner = std::move(under);
        return true;
    });
}

Alterations lost_dot(const Row& right) { return without_accent(right, math::AccentKind::dot); }
Alterations lost_tilde(const Row& right) { return without_accent(right, math::AccentKind::tilde); }

/// ã b becomes b̃ a: the order of a vector product.
Alterations exchanged_factors(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        if (k + 1 >= row.size()) { return false; }
        const Letter first = letter_of(row[k]);
        const Letter second = letter_of(row[k + 1]);
        const auto* const accent = std::get_if<math::Accent>(&row[k].nucleus);
        const bool tilde = accent != nullptr && accent->kind == math::AccentKind::tilde;
        const bool vectors = is_letter(first, {"s", "ω", "d"}) && is_letter(second, {"s", "ω", "d"});
        if (!tilde || !vectors) { return false; }
        std::swap(first.sign->utf8, second.sign->utf8);
        std::swap(first.node->below, second.node->below);
        std::swap(first.node->above, second.node->above);
        return true;
    });
}

Alterations other_point(const Row& right) {
    return once_and_everywhere(right, [](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (!is_letter(letter, {"s"})) { return false; }
        return erase_sign(letter.node->above, "B");
    });
}

Alterations other_jacobian(const Row& right) {
    const Row mark = math::own_math("x^{(m)}").front().above;
    return once_and_everywhere(right, [&](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (!is_letter(letter, {"Φ", "γ"})) { return false; }
        formula::Superscript script;
        const formula::Symbol symbol =
            formula::symbol_of(letter.sign->utf8, letter.node->below, letter.node->above, script);
        const bool modified = symbol.marks.find("(m)") != std::string::npos;
        const bool angular = symbol.index.starts_with("p") || symbol.letter == "γ";
        if (!angular || (!modified && !symbol.marks.empty())) { return false; }
        letter.node->above = modified ? Row{} : mark;
        return true;
    });
}

Alterations not_normalised(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        auto* const fraction = std::get_if<math::Fraction>(&row[k].nucleus);
        const auto is_length = [](const Node& n) {
            const auto* const group = std::get_if<math::Group>(&n.nucleus);
            return is_kind(n, SignKind::fence) || (group != nullptr && (group->open == "|" || group->open == "‖"));
        };
        if (fraction == nullptr || std::ranges::none_of(fraction->below, is_length)) { return false; }
        Node group;
        group.nucleus = math::Group{"", "", fraction->above};
        row[k] = std::move(group);
        return true;
    });
}

bool exchange_function(Row& row, std::size_t k) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kPairs{
        {{"sin", "cos"}, {"largest", "smallest"}}};
    auto* const sign = std::get_if<Sign>(&row[k].nucleus);
    if (sign == nullptr || sign->kind != SignKind::function) { return false; }
    for (const auto& [a, b] : kPairs) {
        if (sign->utf8 != a && sign->utf8 != b) { continue; }
        sign->utf8 = sign->utf8 == a ? b : a;
        return true;
    }
    return false;
}

Alterations other_function(const Row& right) { return once_and_everywhere(right, exchange_function); }

/// Place behind the parenthesis that opens at `k`.
std::size_t end_of_parentheses(const Row& row, std::size_t k) {
    int depth = 0;
    for (; k < row.size(); ++k) {
        if (is_kind(row[k], SignKind::opening)) { ++depth; }
        if (is_kind(row[k], SignKind::closing) && --depth == 0) { return k + 1; }
    }
    return row.size();
}

/// sin(x) becomes sin(x 180/π): the argument was taken to be in degrees.
Alterations degrees_in_function(const Row& right) {
    return changed_everywhere(right, [](Row& row, std::size_t k) {
        const auto* const sign = std::get_if<Sign>(&row[k].nucleus);
        const bool trigonometric = sign != nullptr && sign->kind == SignKind::function &&
                                   (sign->utf8 == "sin" || sign->utf8 == "cos" || sign->utf8 == "tan");
        if (!trigonometric || k + 1 >= row.size()) { return false; }
        const std::size_t end =
            is_kind(row[k + 1], SignKind::opening) ? end_of_parentheses(row, k + 1) : k + 2;
        Row inner(row.begin() + static_cast<std::ptrdiff_t>(k) + 1, row.begin() + static_cast<std::ptrdiff_t>(end));
        const Row factor = math::own_math("\\frac{180}{\\pi}");
        inner.insert(inner.begin(), factor.begin(), factor.end());
        Node group;
        group.nucleus = math::Group{"", "", std::move(inner)};
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(k) + 1, row.begin() + static_cast<std::ptrdiff_t>(end));
        row.insert(row.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(group));
        return true;
    });
}

constexpr std::array kFormulaMistakes{
    FormulaMistake{
        "sign", "wrong sign", "This is the right answer with the opposite sign.", "", wrong_sign},
    FormulaMistake{
        "term-sign", "wrong sign of a term", "One term has the wrong sign: the sign {} of the formula is reversed.", "",
        sign_of_term},
    FormulaMistake{
        "term-dropped", "a term is missing", "A term is missing, the one that begins with {}.", "", dropped_term},
    FormulaMistake{
        "bodies-exchanged", "i and j exchanged",
        "The bodies i and j are exchanged: d points from i to j, and s_i belongs to body i.", "slide 2",
        exchanged_bodies},
    FormulaMistake{
        "wrong-body", "a symbol of the other body", "{} was taken from the other body: mind the index i or j.", "slide 2",
        wrong_body},
    FormulaMistake{
        "local-for-global", "components of the body for global ones",
        "{} is needed in the global frame; you have used its components in the frame of the body: s = A s′.",
        "slide 2", local_for_global},
    FormulaMistake{
        "global-for-local", "global components for those of the body",
        "{} is needed in the frame of the body; you have used its global components: s′ = Aᵀ s.", "slide 2",
        global_for_local},
    FormulaMistake{
        "matrix-forgotten", "rotation matrix forgotten", "The rotation matrix {} is missing.", "slide 3",
        forgotten_matrix},
    FormulaMistake{
        "matrix-transposed", "a matrix transposed",
        "{} is transposed: A turns components of the body into global ones, Aᵀ the other way.", "slide 3",
        transposed_matrix},
    FormulaMistake{
        "transposed", "the answer transposed", "This is the transpose of the right answer.", "", transposed},
    FormulaMistake{
        "g-for-l", "G and L mixed up", "{} is the wrong one of G and L: ω = 2 G ṗ, ω′ = 2 L ṗ.", "slide 13", g_for_l},
    FormulaMistake{"factor", "a factor is lost", "The factor {} is lost.", "slide 13", lost_factor},
    FormulaMistake{"square", "a square is lost", "{} has lost its square.", "", lost_square},
    FormulaMistake{
        "dot", "a dot is lost", "{} has lost its dot: the derivative is needed, not the vector.", "slides 14-17",
        lost_dot},
    FormulaMistake{
        "tilde", "a tilde is lost", "{} has lost its tilde: it has to be the skew matrix.", "slide 3", lost_tilde},
    FormulaMistake{
        "order-of-product", "factors of a vector product exchanged",
        "The factors of the vector product that begins with {} are exchanged: ã b = −b̃ a.", "slide 3",
        exchanged_factors},
    FormulaMistake{
        "axis-for-point", "the axis used for the point",
        "{} is the vector to the point B; you have used the axis s instead.", "slide 2", other_point},
    FormulaMistake{
        "other-jacobian", "true and modified Jacobian mixed up",
        "This is the other one of the true and the modified Jacobian: they differ by c pᵀ.", "slides 21-22",
        other_jacobian},
    FormulaMistake{
        "not-normalised", "not normalised", "The result has to be divided by its length.", "slide 23", not_normalised},
    FormulaMistake{
        "other-function", "the other function", "{} is the wrong function here.", "slide 5", other_function},
    FormulaMistake{
        "degrees-in-function", "degrees in a function", "The functions take radians, not degrees.", "",
        degrees_in_function}};

}  // namespace

std::span<const FormulaMistake> formula_mistakes() { return kFormulaMistakes; }

}  // namespace jw
