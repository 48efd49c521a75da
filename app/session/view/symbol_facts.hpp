#pragma once

#include <string>

#include "lessons/formula/symbol.hpp"

/// What the book says about a symbol, whatever body or joint it belongs to.
namespace jw {

struct SymbolFact {
    const char* letter;
    const char* marks;    ///< as in formula::Symbol; nullptr: any
    const char* meaning;  ///< to be translated
    const char* unit;     ///< without dots; "" if it has none
    const char* slide;    ///< where it is defined
};

/// @return nullptr for symbols that the book does not define
const SymbolFact* fact_of(const formula::Symbol& symbol);

/// Unit of a symbol with dots: "m/s²" of "m" with two; empty for a symbol without unit and without dots.
std::string unit_of_rate(const std::string& unit, int dots);

}  // namespace jw
