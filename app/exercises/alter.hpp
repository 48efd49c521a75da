#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/math/math.hpp"

/// Formulas with one thing in them changed.
namespace jw {

/// A formula after a change.
struct Altered {
    math::Row row;
    std::string what;  ///< the thing that was changed, as plain text: "s̃ᵢ"
};

/// Changes what stands at place `k` of a row, itself or with its neighbours.
/// @return false, with nothing changed, if there is nothing to change
using Change = std::function<bool(math::Row& row, std::size_t k)>;

/// The formula changed at one place, for each place where `change` changes something: all rows are looked at,
/// those within fractions, groups and accents, too, but not the scripts of letters.
/// @param what  tells what is changed; default: the node at the place
using Telling = std::function<std::string(const math::Row& row, std::size_t k)>;
std::vector<Altered> changed_once(const math::Row& formula, const Change& change, const Telling& what = {});
/// The formula changed at all places at once; nothing if there are none.
std::vector<Altered> changed_everywhere(
    const math::Row& formula, const Change& change, const Telling& what = {});

/// The letter that a node with its accents is about, with its scripts; nothing for others.
struct Letter {
    math::Sign* sign = nullptr;
    math::Node* node = nullptr;  ///< whose scripts are those of the letter
};
Letter letter_of(math::Node& node);

}  // namespace jw
