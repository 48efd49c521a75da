#include "lessons/formula/symbol.hpp"

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
    for (const math::Node& node : above) {
        if (is_sign(node, "T")) {
            script.transposed = true;
            continue;
        }
        const bool other_letter = is_kind(node, math::SignKind::letter) && !is_sign(node, "π");
        if (other_letter || is_sign(node, "′")) { return false; }
        script.power.push_back(node);
    }
    return true;
}

Symbol symbol_of(
    const std::string& letter, const math::Row& below, const math::Row& above, Superscript& script) {
    Symbol symbol{letter, 0, {}, index_text(below)};
    bool in_name = false;
    for (const math::Node& node : above) {
        const math::Sign* const sign = sign_of(node);
        const std::string s = sign == nullptr ? "" : sign->utf8;
        const bool is_zero_mark = s == "0" && script.power.empty();
        const bool begins_power =
            sign == nullptr || s == "−" || (sign->kind == math::SignKind::number && !is_zero_mark);
        if (in_name) {
            symbol.marks += s;
            in_name = s != ")";
        } else if (s == "′") {
            ++symbol.primes;
        } else if (s == "T") {
            script.transposed = true;
        } else if (begins_power || !script.power.empty()) {
            script.power.push_back(node);
        } else {
            symbol.marks += s;
            in_name = s == "(";
        }
    }
    return symbol;
}

}  // namespace jw::formula
