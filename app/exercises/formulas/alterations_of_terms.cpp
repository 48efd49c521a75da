#include <algorithm>
#include <set>

#include "app/exercises/formulas/alterations.hpp"
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

/// Place after the term that begins at `k`.
std::size_t end_of_term(const Row& row, std::size_t k) {
    int depth = 0;
    for (++k; k < row.size(); ++k) {
        if (is_kind(row[k], SignKind::opening)) { ++depth; }
        if (is_kind(row[k], SignKind::closing) && --depth < 0) { break; }
        if (depth == 0 && is_sign_of_sum(row[k])) { break; }
    }
    return k;
}

/// True if the first term of a sum, or of an expression in parentheses, begins at place `k`.
bool begins_sum(const Row& row, std::size_t k) { return k == 0 || is_kind(row[k - 1], SignKind::opening); }

/// True if a term begins at place `k`, with its sign, and there is another term beside it.
bool begins_one_of_terms(const Row& row, std::size_t k) {
    if (!is_sign_of_sum(row[k]) && !begins_sum(row, k)) { return false; }
    const std::size_t end = end_of_term(row, k);
    return !begins_sum(row, k) || (end < row.size() && !is_kind(row[end], SignKind::closing));
}

std::string term_at(const Row& row, std::size_t k) {
    const auto from = row.begin() + static_cast<std::ptrdiff_t>(k + (is_sign_of_sum(row[k]) ? 1 : 0));
    return math::write_plain(Row(from, row.begin() + static_cast<std::ptrdiff_t>(end_of_term(row, k))));
}

/// The formula changed once at each place; and, for each name that stands at several places, changed at all
/// of them.
/// @param name_at  name at a place; empty if there is nothing to change
Alterations once_and_everywhere(
    const Row& right, const Telling& name_at, const std::function<void(Row&, std::size_t)>& change,
    const Telling& what = {}) {
    std::set<std::string> names;
    const auto changing = [&](const std::string& only) {
        return [&, only](Row& row, std::size_t k) {
            const std::string name = name_at(row, k);
            if (name.empty() || (!only.empty() && name != only)) { return false; }
            names.insert(name);
            change(row, k);
            return true;
        };
    };
    Alterations all = changed_once(right, changing({}), what);
    for (const std::string& name : std::set<std::string>(names)) {
        std::ranges::move(changed_everywhere(right, changing(name), what), std::back_inserter(all));
    }
    return all;
}

}  // namespace

Alterations wrong_sign(const Row& right) {
    Altered altered{math::own_math("-"), "the answer"};
    // parentheses only if they hold several terms together
    const bool sum = std::ranges::any_of(right, is_sign_of_sum);
    altered.row.push_back(sum ? group_of("(", ")", right) : group_of("", "", right));
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

Alterations dropped_term(const Row& right) {
    const auto name = [](const Row& row, std::size_t k) {
        return begins_one_of_terms(row, k) ? term_at(row, k) : std::string();
    };
    const auto drop = [](Row& row, std::size_t k) {
        const bool first = begins_sum(row, k);
        take_out(row, k, end_of_term(row, k) - k);
        // no plus may be left over at the front
        if (first && is_sign(row[k], "+")) { take_out(row, k); }
    };
    return once_and_everywhere(right, name, drop, term_at);
}

Alterations lost_factor(const Row& right) {
    const auto name = [](const Row& row, std::size_t k) {
        const auto* const sign = std::get_if<Sign>(&row[k].nucleus);
        const bool factor =
            sign != nullptr && sign->kind == SignKind::number && sign->utf8 != "1" && sign->utf8 != "0";
        return factor ? sign->utf8 : std::string();
    };
    const auto lose = [](Row& row, std::size_t k) { std::get<Sign>(row[k].nucleus).utf8 = "1"; };
    return once_and_everywhere(right, name, lose);
}

}  // namespace jw::alterations
