#pragma once

#include <string>
#include <vector>

#include "app/session/view/derivation.hpp"
#include "app/session/view/symbols.hpp"

/// Text beside the pointer, line by line, with formulas between dollar signs.
namespace jw {

/// What a symbol is, and its value for each thing that it can mean.
std::vector<std::string> symbol_tip(const SymbolView& symbol);

/// The formula of a block of Φq, the formula with its numbers, and the row of the entry.
std::vector<std::string> derivation_tip(const Derivation& derivation);

}  // namespace jw
