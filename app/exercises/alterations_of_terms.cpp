#include <algorithm>
#include <set>

#include "app/exercises/alterations.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"

/// Mistakes in the terms of a sum, and in its numbers.
namespace jw::alterations {

namespace {

using math::Node;
using math::Row;
using math::Sign;
using math::SignKind;

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

/// True if the first term of a sum, or of what stands in parentheses, begins at place `k`.
bool begins_sum(const Row& row, std::size_t k) { return k == 0 || is_kind(row[k - 1], SignKind::opening); }

/// True if a term begins at place `k`, with its sign, and another one stands beside it.
bool begins_one_of_terms(const Row& row, std::size_t k) {
    if (!is_sign_of_sum(row[k]) && !begins_sum(row, k)) { return false; }
    const std::size_t end = end_of_term(row, k);
    return !begins_sum(row, k) || (end < row.size() && !is_kind(row[end], SignKind::closing));
}

std::string term_at(const Row& row, std::size_t k) {
    const auto from = row.begin() + static_cast<std::ptrdiff_t>(k + (is_sign_of_sum(row[k]) ? 1 : 0));
    return math::write_plain(Row(from, row.begin() + static_cast<std::ptrdiff_t>(end_of_term(row, k))));
}

}  // namespace

Alterations wrong_sign(const Row& right) {
    Altered altered{math::own_math("-"), "the answer"};
    Node group;
    // parentheses only where there is something to hold together
    const bool sum = std::ranges::any_of(right, is_sign_of_sum);
    group.nucleus = sum ? math::Group{"(", ")", right} : math::Group{"", "", right};
    altered.row.push_back(std::move(group));
    return {altered};
}

Alterations sign_of_term(const Row& right) {
    return changed_once(
        right,
        [](Row& row, std::size_t k) {
            const bool minus = is_sign(row[k], "−");
            if (!minus && !is_sign(row[k], "+")) { return false; }
            std::get<Sign>(row[k].nucleus).utf8 = minus ? "+" : "−";
            return true;
        },
        term_at);
}

/// Once at each place, and one that stands at several places at all of them.
Alterations dropped_term(const Row& right) {
    std::set<std::string> terms;
    const auto drop = [&](const std::string& only) {
        return [&terms, only](Row& row, std::size_t k) {
            if (!begins_one_of_terms(row, k)) { return false; }
            const std::string term = term_at(row, k);
            if (!only.empty() && term != only) { return false; }
            terms.insert(term);
            const bool first = begins_sum(row, k);
            row.erase(
                row.begin() + static_cast<std::ptrdiff_t>(k),
                row.begin() + static_cast<std::ptrdiff_t>(end_of_term(row, k)));
            // no plus is left over at the front
            if (first && is_sign(row[k], "+")) { row.erase(row.begin() + static_cast<std::ptrdiff_t>(k)); }
            return true;
        };
    };
    Alterations all = changed_once(right, drop({}), term_at);
    for (const std::string& term : std::set<std::string>(terms)) {
        for (Altered& altered : changed_everywhere(right, drop(term))) {
            all.push_back({std::move(altered.row), term});
        }
    }
    return all;
}

/// Once at each place, and one that stands at several places at all of them.
Alterations lost_factor(const Row& right) {
    std::set<std::string> numbers;
    const auto lose = [&](const std::string& only) {
        return [&numbers, only](Row& row, std::size_t k) {
            auto* const sign = std::get_if<Sign>(&row[k].nucleus);
            if (sign == nullptr || sign->kind != SignKind::number || sign->utf8 == "1" || sign->utf8 == "0") {
                return false;
            }
            if (!only.empty() && sign->utf8 != only) { return false; }
            numbers.insert(sign->utf8);
            sign->utf8 = "1";
            return true;
        };
    };
    Alterations all = changed_once(right, lose({}));
    for (const std::string& number : std::set<std::string>(numbers)) {
        std::ranges::move(changed_everywhere(right, lose(number)), std::back_inserter(all));
    }
    return all;
}

}  // namespace jw::alterations
