#pragma once

#include <string>

#include "lessons/math/math.hpp"

/// Names of the symbols in a formula.
namespace jw::formula {

/// A letter with its primes, marks and index, without accents, transpose or power. `\dot{\mathbf{s}}_i'^{P
/// T}` has the letter s, one prime, the mark P and the index i.
struct Symbol {
    std::string letter;
    int primes = 0;
    std::string marks;  ///< "P", "(m)", "#(n1,1)"
    std::string index;  ///< "i", "p_i", "ω′_i", "0"

    bool operator==(const Symbol&) const = default;
};

/// Name of the symbol in messages: "s′_i^P".
std::string name_of(const Symbol& symbol);

/// Superscript of a symbol, without its primes and marks.
struct Superscript {
    bool transposed = false;
    math::Row power;  ///< an expression; empty: there is none
};

/// Splits the scripts of a letter; `index` is written without spaces.
Symbol symbol_of(
    const std::string& letter, const math::Row& below, const math::Row& above, Superscript& script);

/// Reads transposes and powers of something that is not a symbol. @return false if anything else stands there
bool read_superscript(const math::Row& above, Superscript& script);

}  // namespace jw::formula
