#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lessons/formula/symbol.hpp"
#include "lessons/math/math.hpp"

/// The symbols that stand in a formula, and what is known of each wherever it stands.
namespace jw::formula {

/// A symbol as it stands in a formula, without what only arranges it there: `\tilde{\mathbf{s}}_i^T` is the
/// vector `\mathbf{s}_i`. Dots stay, since a rate is another thing.
struct TextSymbol {
    math::Node node;     ///< without tilde, bar, transpose and power
    std::string source;  ///< of the node, as docs/mathematics.md says: the same symbol has the same source
    Symbol name;         ///< without dots
    int dots = 0;
    bool bold = false;

    bool operator==(const TextSymbol&) const = default;
};

/// The symbol of a node; nothing if it is none: numbers, operators, the names of functions, units, and the
/// letters of other alphabets.
std::optional<TextSymbol> text_symbol_of(const math::Node& node);

/// Calls `found` with every symbol of a formula, also those in fractions, roots, brackets and matrices.
void for_each_symbol(const math::Row& row, const std::function<void(const TextSymbol&)>& found);

}  // namespace jw::formula
