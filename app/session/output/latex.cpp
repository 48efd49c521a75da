#include <algorithm>
#include <array>
#include <string_view>

#include "app/session/output/export.hpp"

namespace jw {

namespace {

struct Symbol {
    std::string_view utf8;
    std::string_view latex;
};

/// Symbols in labels; a command is followed by a space where a letter may come next.
constexpr std::array kSymbols{
    Symbol{"−", "-"},        Symbol{"≡", "\\equiv "},  Symbol{"×", "\\times "},  Symbol{"·", "\\cdot "},
    Symbol{"′", "\\prime "}, Symbol{"Φ", "\\Phi "},    Symbol{"Δ", "\\Delta "},  Symbol{"α", "\\alpha "},
    Symbol{"γ", "\\gamma "}, Symbol{"θ", "\\theta "},  Symbol{"λ", "\\lambda "}, Symbol{"ν", "\\nu "},
    Symbol{"σ", "\\sigma "}, Symbol{"φ", "\\varphi "}, Symbol{"ω", "\\omega "},  Symbol{"‖", "\\Vert "},
    Symbol{"∞", "\\infty "}, Symbol{"√", "\\surd "},   Symbol{"→", "\\to "},
};

/// Characters of labels that are subscripts or superscripts.
constexpr std::array kScripts{
    Symbol{"₀", "_{0}"}, Symbol{"₁", "_{1}"},           Symbol{"₂", "_{2}"}, Symbol{"₃", "_{3}"},
    Symbol{"ᵢ", "_{i}"}, Symbol{"ⱼ", "_{j}"},           Symbol{"²", "^{2}"}, Symbol{"⁰", "^{0}"},
    Symbol{"ᴾ", "^{P}"}, Symbol{"ᵀ", "^{\\mathsf{T}}"}, Symbol{"ᴮ", "^{B}"},
};

/// Characters with a special meaning in LaTeX text, and how they are written.
constexpr std::array kEscaped{
    Symbol{"\\", "\\textbackslash{}"},
    Symbol{"~", "\\textasciitilde{}"},
    Symbol{"^", "\\textasciicircum{}"},
    Symbol{"#", "\\#"},
    Symbol{"$", "\\$"},
    Symbol{"%", "\\%"},
    Symbol{"&", "\\&"},
    Symbol{"_", "\\_"},
    Symbol{"{", "\\{"},
    Symbol{"}", "\\}"}};

template <std::size_t N>
const Symbol* symbol_at(const std::array<Symbol, N>& symbols, std::string_view text) {
    const auto found =
        std::ranges::find_if(symbols, [&](const Symbol& s) { return text.starts_with(s.utf8); });
    return found == symbols.end() ? nullptr : &*found;
}

std::string trimmed(std::string_view command) {
    while (command.ends_with(' ')) { command.remove_suffix(1); }
    return std::string(command);
}

}  // namespace

std::string latex_text(const std::string& text) {
    std::string latex;
    std::string_view rest = text;
    while (!rest.empty()) {
        if (const Symbol* const escaped = symbol_at(kEscaped, rest)) {
            latex += escaped->latex;
            rest.remove_prefix(escaped->utf8.size());
            continue;
        }
        const Symbol* symbol = symbol_at(kSymbols, rest);
        if (symbol == nullptr) { symbol = symbol_at(kScripts, rest); }
        if (symbol == nullptr) {
            latex += rest.front();
            rest.remove_prefix(1);
            continue;
        }
        // here a prime has no letter before it
        const bool prime = symbol->utf8 == "′";
        latex += "$" + (prime ? std::string("{}^{\\prime}") : trimmed(symbol->latex)) + "$";
        rest.remove_prefix(symbol->utf8.size());
    }
    return latex;
}

}  // namespace jw
