#include <algorithm>
#include <array>
#include <string_view>

#include "app/exercises/formulas/alterations.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"

namespace jw::alterations {

namespace {

using math::Node;
using math::Row;
using math::Sign;
using math::SignKind;

Node sign_node(const char* utf8, SignKind kind) {
    Node node;
    node.nucleus = Sign{utf8, kind, math::Alphabet::italic};
    return node;
}

/// The formula changed once at each place, and at all places at once.
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

bool is_primed(const Node& node) {
    return std::ranges::any_of(node.above, [](const Node& n) { return is_sign(n, "′"); });
}

Alterations exchange_letters(const Row& right, std::string_view a, std::string_view b) {
    return once_and_everywhere(right, [=](Row& row, std::size_t k) {
        const Letter letter = letter_of(row[k]);
        if (letter.sign == nullptr || (letter.sign->utf8 != a && letter.sign->utf8 != b)) { return false; }
        letter.sign->utf8 = letter.sign->utf8 == a ? b : a;
        return true;
    });
}

/// Takes an accent of this kind off a letter.
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

/// Place after the parenthesis that opens at `k`.
std::size_t end_of_parentheses(const Row& row, std::size_t k) {
    int depth = 0;
    for (; k < row.size(); ++k) {
        if (is_kind(row[k], SignKind::opening)) { ++depth; }
        if (is_kind(row[k], SignKind::closing) && --depth == 0) { return k + 1; }
    }
    return row.size();
}

}  // namespace

Alterations exchanged_bodies(const Row& right) {
    Alterations all = changed_everywhere(right, exchange_bodies);
    return all.empty() ? changed_once(right, exchange_bodies) : all;
}

Alterations wrong_body(const Row& right) {
    return changed_everywhere(right, exchange_bodies).empty() ? Alterations{}
                                                              : changed_once(right, exchange_bodies);
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
        take_out(row, k);
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
    Node group = group_of("", "", right);
    group.above.push_back(sign_node("T", SignKind::letter));
    return {{{group}, "the answer"}};
}

/// The answer multiplied by A or by its transpose. Only one of them changes the frame; nobody writes the
/// other vector.
Alterations other_frame(const Row& right) {
    Alterations all;
    for (const char* turn : {"A", "A^T"}) {
        Altered altered{math::own_math(turn), "the answer"};
        altered.row.push_back(group_of("(", ")", right));
        all.push_back(std::move(altered));
    }
    return all;
}

Alterations g_for_l(const Row& right) { return exchange_letters(right, "G", "L"); }

Alterations lost_square(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        return !std::holds_alternative<math::Accent>(row[k].nucleus) && erase_sign(row[k].above, "2");
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

/// A quotient by a length loses its denominator.
Alterations not_normalised(const Row& right) {
    const auto is_length = [](const Node& n) {
        const auto* const group = std::get_if<math::Group>(&n.nucleus);
        return is_kind(n, SignKind::fence) ||
               (group != nullptr && (group->open == "|" || group->open == "‖"));
    };
    const auto undivided = [&](Row& row, std::size_t k) {
        auto* const fraction = std::get_if<math::Fraction>(&row[k].nucleus);
        if (fraction == nullptr || std::ranges::none_of(fraction->below, is_length)) { return false; }
        row[k] = group_of("", "", Row(fraction->above));
        return true;
    };
    return changed_once(right, undivided, [](const Row& row, std::size_t k) {
        return math::write_plain(std::get<math::Fraction>(row[k].nucleus).below);
    });
}

Alterations other_function(const Row& right) { return once_and_everywhere(right, exchange_function); }

/// sin(x) becomes sin(x 180/π): the mistake is to take the argument as degrees.
Alterations degrees_in_function(const Row& right) {
    return changed_everywhere(right, [](Row& row, std::size_t k) {
        const auto* const sign = std::get_if<Sign>(&row[k].nucleus);
        const bool trigonometric = sign != nullptr && sign->kind == SignKind::function &&
                                   (sign->utf8 == "sin" || sign->utf8 == "cos" || sign->utf8 == "tan");
        if (!trigonometric || k + 1 >= row.size()) { return false; }
        const std::size_t end =
            is_kind(row[k + 1], SignKind::opening) ? end_of_parentheses(row, k + 1) : k + 2;
        Row inner(
            row.begin() + static_cast<std::ptrdiff_t>(k) + 1, row.begin() + static_cast<std::ptrdiff_t>(end));
        const Row factor = math::own_math("\\frac{180}{\\pi}");
        inner.insert(inner.begin(), factor.begin(), factor.end());
        take_out(row, k + 2, end - k - 2);
        row[k + 1] = group_of("", "", std::move(inner));
        return true;
    });
}

/// Leaves out the inverse in front of the right side of equations.
Alterations forgotten_inverse(const Row& right) {
    return changed_once(right, [](Row& row, std::size_t k) {
        const Row& above = row[k].above;
        const bool inverse =
            above.size() >= 2 && is_sign(above[above.size() - 2], "−") && is_sign(above.back(), "1");
        if (!inverse || row.size() < 2) { return false; }
        take_out(row, k);
        return true;
    });
}

/// s_{zi} becomes s_{xi}, and s_{yi}.
Alterations other_component(const Row& right) {
    constexpr std::string_view kAxes = "xyz";
    Alterations all;
    for (std::size_t onwards = 1; onwards < kAxes.size(); ++onwards) {
        const auto change = [&](Row& row, std::size_t k) {
            const Letter letter = letter_of(row[k]);
            if (letter.node == nullptr || letter.node->below.empty()) { return false; }
            auto* const index = std::get_if<Sign>(&letter.node->below.front().nucleus);
            const std::size_t axis =
                index != nullptr && index->utf8.size() == 1 ? kAxes.find(index->utf8) : std::string::npos;
            if (axis == std::string::npos) { return false; }
            index->utf8 = kAxes[(axis + onwards) % kAxes.size()];
            return true;
        };
        std::ranges::move(changed_once(right, change), std::back_inserter(all));
    }
    return all;
}

}  // namespace jw::alterations
