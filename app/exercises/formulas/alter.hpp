#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/math/math.hpp"

/// Formulas with one part changed.
namespace jw {

/// A formula after a change.
struct Altered {
    math::Row row;
    std::string what;  ///< the part that was changed, as plain text: "s̃ᵢ"
};

/// Changes the node at place `k` of a row, alone or with its neighbours.
/// @return false, with nothing changed, if there is nothing to change
using Change = std::function<bool(math::Row& row, std::size_t k)>;

/// Names the part that is changed; default: the node at the place.
using Telling = std::function<std::string(const math::Row& row, std::size_t k)>;
/// The formula changed at one place, for each place where `change` changes something. All rows are visited,
/// also those within fractions, groups and accents, but not the scripts of letters.
std::vector<Altered> changed_once(const math::Row& formula, const Change& change, const Telling& what = {});
/// The formula changed at all places at once; nothing if there are fewer than two.
std::vector<Altered> changed_everywhere(
    const math::Row& formula, const Change& change, const Telling& what = {});

/// The letter of a node with accents, and its scripts; nothing for other nodes.
struct Letter {
    math::Sign* sign = nullptr;
    math::Node* node = nullptr;  ///< the node that has the letter's scripts
};
Letter letter_of(math::Node& node);

/// A row as one node; with empty texts, without parentheses.
math::Node group_of(const char* open, const char* close, math::Row inner);

/// Takes `count` nodes out of a row.
void take_out(math::Row& row, std::size_t from, std::size_t count = 1);

}  // namespace jw
