#include "app/session/output/symbol_tip.hpp"

#include "app/session/wording/markup.hpp"
#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

void join(std::string& text, const std::string& more) {
    if (!more.empty()) { text += (text.empty() ? "" : " · ") + more; }
}

std::string meaning_line(const SymbolView& symbol, const SymbolMeaning& meaning, bool several) {
    const std::string owner = several && !meaning.owner.empty() ? meaning.owner + ":  " : "";
    std::string line = owner + "$" + meaning.source + " = " + matrix_markup(meaning.value) + "$";
    if (!symbol.unit.empty()) { line += " " + symbol.unit; }
    return meaning.frame.empty() ? line : line + "  " + meaning.frame;
}

}  // namespace

std::vector<std::string> symbol_tip(const SymbolView& symbol) {
    std::string head = symbol.what;
    const bool several = symbol.meanings.size() > 1;
    if (!several) { join(head, symbol.meanings.front().owner); }
    join(head, symbol.defined);
    std::vector<std::string> lines;
    if (!head.empty()) { lines.push_back(head); }
    for (const SymbolMeaning& meaning : symbol.meanings) {
        lines.push_back(meaning_line(symbol, meaning, several));
    }
    if (symbol.more > 0) { lines.push_back(tr("and {0} more", symbol.more)); }
    return lines;
}

std::vector<std::string> derivation_tip(const Derivation& derivation) {
    std::vector<std::string> lines{"$" + derivation.formula + "$"};
    if (!derivation.numbers.empty()) { lines.push_back("$= " + derivation.numbers + "$"); }
    if (!derivation.block.empty()) { lines.push_back("$= " + derivation.block + "$"); }
    if (!derivation.row.empty()) { lines.push_back(derivation.row); }
    return lines;
}

}  // namespace jw
