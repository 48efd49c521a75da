#include "app/exercises/formulas/alterations.hpp"

#include <utility>

#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

using math::Node;
using math::Row;

/// Calls `visit` with each row of the tree, except scripts; stops when `visit` returns true.
bool any_row(Row& row, const std::function<bool(Row&)>& visit) {
    if (visit(row)) { return true; }
    for (Node& node : row) {
        if (auto* const fraction = std::get_if<math::Fraction>(&node.nucleus)) {
            if (any_row(fraction->above, visit) || any_row(fraction->below, visit)) { return true; }
        } else if (auto* const root = std::get_if<math::Root>(&node.nucleus)) {
            if (any_row(root->inner, visit)) { return true; }
        } else if (auto* const group = std::get_if<math::Group>(&node.nucleus)) {
            if (any_row(group->inner, visit)) { return true; }
        } else if (auto* const accent = std::get_if<math::Accent>(&node.nucleus)) {
            // a letter with its accents is treated as one symbol
            if (letter_of(node).sign == nullptr && any_row(accent->inner, visit)) { return true; }
        } else if (auto* const matrix = std::get_if<math::Matrix>(&node.nucleus)) {
            for (auto& cells : matrix->rows) {
                for (Row& cell : cells) {
                    if (any_row(cell, visit)) { return true; }
                }
            }
        }
    }
    return false;
}

}  // namespace

Letter letter_of(Node& node) {
    if (auto* const sign = std::get_if<math::Sign>(&node.nucleus)) {
        return sign->kind == math::SignKind::letter ? Letter{sign, &node} : Letter{};
    }
    auto* const accent = std::get_if<math::Accent>(&node.nucleus);
    if (accent == nullptr || accent->inner.size() != 1) { return {}; }
    Letter inner = letter_of(accent->inner.front());
    // \tilde{s}_i has its scripts outside the accent, \tilde{s_i} inside
    if (inner.node != nullptr && inner.node->below.empty() && inner.node->above.empty()) {
        inner.node = &node;
    }
    return inner;
}

std::vector<Altered> changed_once(const Row& formula, const Change& change, const Telling& what) {
    std::vector<Altered> all;
    // one place after the other, until no more is found
    for (std::size_t place = 0;; ++place) {
        Altered altered{formula, {}};
        std::size_t at = 0;
        const bool found = any_row(altered.row, [&](Row& row) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                Row tried = row;
                if (!change(tried, k)) { continue; }
                if (at++ != place) { continue; }
                altered.what = what ? what(row, k) : math::write_plain({row[k]});
                row = std::move(tried);
                return true;
            }
            return false;
        });
        if (!found) { return all; }
        all.push_back(std::move(altered));
    }
}

std::vector<Altered> changed_everywhere(const Row& formula, const Change& change, const Telling& what) {
    Altered altered{formula, {}};
    int places = 0;
    any_row(altered.row, [&](Row& row) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            const Row before = row;
            if (!change(row, k)) { continue; }
            if (places++ == 0) { altered.what = what ? what(before, k) : math::write_plain({before[k]}); }
        }
        return false;
    });
    // with only one place, the result is that of changed_once
    return places > 1 ? std::vector<Altered>{std::move(altered)} : std::vector<Altered>{};
}

Node group_of(const char* open, const char* close, Row inner) {
    Node group;
    group.nucleus = math::Group{open, close, std::move(inner)};
    return group;
}

void take_out(Row& row, std::size_t from, std::size_t count) {
    const auto begin = row.begin() + static_cast<std::ptrdiff_t>(from);
    row.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
}

}  // namespace jw
