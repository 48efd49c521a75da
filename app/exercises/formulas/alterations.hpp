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

/// Letter under the accents of a node, and the node with its scripts; empty for a node without a letter.
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

/// Formulas with one mistake: one altered formula for each place where the mistake can be made, and often one
/// with the mistake made everywhere.
namespace jw::alterations {

using Alterations = std::vector<Altered>;

Alterations wrong_sign(const math::Row& right);
Alterations sign_of_term(const math::Row& right);
Alterations dropped_term(const math::Row& right);
Alterations exchanged_bodies(const math::Row& right);
Alterations wrong_body(const math::Row& right);
Alterations local_for_global(const math::Row& right);
Alterations global_for_local(const math::Row& right);
Alterations forgotten_matrix(const math::Row& right);
Alterations transposed_matrix(const math::Row& right);
Alterations transposed(const math::Row& right);
Alterations other_frame(const math::Row& right);
Alterations g_for_l(const math::Row& right);
Alterations lost_factor(const math::Row& right);
Alterations lost_square(const math::Row& right);
Alterations lost_dot(const math::Row& right);
Alterations lost_tilde(const math::Row& right);
Alterations exchanged_factors(const math::Row& right);
Alterations other_point(const math::Row& right);
Alterations other_jacobian(const math::Row& right);
Alterations not_normalised(const math::Row& right);
Alterations other_function(const math::Row& right);
Alterations degrees_in_function(const math::Row& right);
Alterations forgotten_inverse(const math::Row& right);
Alterations other_component(const math::Row& right);

}  // namespace jw::alterations
