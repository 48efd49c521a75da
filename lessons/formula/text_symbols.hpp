#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lessons/formula/symbol.hpp"
#include "lessons/math/math.hpp"

/// Finds the symbols in a formula, independent of how each occurrence is written.
namespace jw::formula {

/// A symbol of a formula, without accents and scripts that depend on its place: `\tilde{\mathbf{s}}_i^T` is
/// the vector `\mathbf{s}_i`. Dots are kept, since a rate is a different quantity.
struct TextSymbol {
    math::Node node;     ///< without tilde, bar, transpose and power
    std::string source;  ///< source of the node (docs/mathematics.md): the same symbol has the same source
    Symbol name;         ///< without dots
    int dots = 0;
    bool bold = false;

    bool operator==(const TextSymbol&) const = default;
};

/// The symbol of a node; nothing for numbers, operators, names of functions, units, and letters of other
/// alphabets.
std::optional<TextSymbol> text_symbol_of(const math::Node& node);

/// Calls `found` with every symbol of a formula, including those in fractions, roots, brackets and matrices.
void for_each_symbol(const math::Row& row, const std::function<void(const TextSymbol&)>& found);

}  // namespace jw::formula
