#include "lessons/formula/symbol.hpp"

#include <cstdlib>

namespace jw::formula {

namespace {

const math::Sign* sign_of(const math::Node& node) { return std::get_if<math::Sign>(&node.nucleus); }

/// "p_i", "ω′_i", "0i"
std::string index_text(const math::Row& row) {
    std::string text;
    for (const math::Node& node : row) {
        const math::Sign* const sign = sign_of(node);
        if (sign == nullptr) { continue; }
        text += sign->utf8;
        for (const math::Node& above : node.above) {
            if (is_sign(above, "′")) { text += "′"; }
        }
        if (!node.below.empty()) { text += "_" + index_text(node.below); }
    }
    return text;
}

}  // namespace

std::string name_of(const Symbol& symbol) {
    std::string name = symbol.letter;
    for (int k = 0; k < symbol.primes; ++k) { name += "′"; }
    if (!symbol.index.empty()) { name += "_" + symbol.index; }
    return name + (symbol.marks.empty() ? "" : "^" + symbol.marks);
}

bool read_superscript(const math::Row& above, Superscript& script) {
    bool negative = false;
    for (const math::Node& node : above) {
        const math::Sign* const sign = sign_of(node);
        if (sign == nullptr) { return false; }
        if (sign->utf8 == "T") {
            script.transposed = true;
        } else if (sign->utf8 == "−") {
            negative = true;
        } else if (sign->kind == math::SignKind::number) {
            script.power =
                static_cast<int>(std::strtol(sign->utf8.c_str(), nullptr, 10)) * (negative ? -1 : 1);
        } else {
            return false;
        }
    }
    return true;
}

Symbol symbol_of(
    const std::string& letter, const math::Row& below, const math::Row& above, Superscript& script) {
    Symbol symbol{letter, 0, {}, index_text(below)};
    bool in_name = false;
    bool negative = false;
    for (const math::Node& node : above) {
        const math::Sign* const sign = sign_of(node);
        if (sign == nullptr) { continue; }
        const std::string& s = sign->utf8;
        if (in_name) {
            symbol.marks += s;
            in_name = s != ")";
        } else if (s == "′") {
            ++symbol.primes;
        } else if (s == "T") {
            script.transposed = true;
        } else if (s == "−") {
            negative = true;
        } else if (sign->kind == math::SignKind::number && s != "0") {
            script.power = static_cast<int>(std::strtol(s.c_str(), nullptr, 10)) * (negative ? -1 : 1);
        } else {
            symbol.marks += s;
            in_name = s == "(";
        }
    }
    return symbol;
}

}  // namespace jw::formula
