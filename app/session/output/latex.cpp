#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "app/session/output/export.hpp"

namespace jw {

namespace {

struct Symbol {
    std::string_view utf8;
    std::string_view latex;
};

/// Symbols in formulas; a command is followed by a space where a letter may come next.
constexpr std::array kSymbols{
    Symbol{"−", "-"},        Symbol{"≡", "\\equiv "},  Symbol{"×", "\\times "},  Symbol{"·", "\\cdot "},
    Symbol{"′", "\\prime "}, Symbol{"Φ", "\\Phi "},    Symbol{"Δ", "\\Delta "},  Symbol{"α", "\\alpha "},
    Symbol{"γ", "\\gamma "}, Symbol{"θ", "\\theta "},  Symbol{"λ", "\\lambda "}, Symbol{"ν", "\\nu "},
    Symbol{"σ", "\\sigma "}, Symbol{"φ", "\\varphi "}, Symbol{"ω", "\\omega "},  Symbol{"‖", "\\Vert "},
    Symbol{"∞", "\\infty "}, Symbol{"√", "\\surd "},   Symbol{"→", "\\to "},
};

/// Small letters that stand for scripts in labels.
constexpr std::array kScripts{
    Symbol{"₀", "_{0}"}, Symbol{"₁", "_{1}"},           Symbol{"₂", "_{2}"}, Symbol{"₃", "_{3}"},
    Symbol{"ᵢ", "_{i}"}, Symbol{"ⱼ", "_{j}"},           Symbol{"²", "^{2}"}, Symbol{"⁰", "^{0}"},
    Symbol{"ᴾ", "^{P}"}, Symbol{"ᵀ", "^{\\mathsf{T}}"}, Symbol{"ᴮ", "^{B}"},
};

/// Characters with a meaning of their own in LaTeX text, and how they are written.
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

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(std::string_view command) {
    while (command.ends_with(' ')) { command.remove_suffix(1); }
    return std::string(command);
}

/// Reads markup as app/panels/parts/formula.cpp does and writes LaTeX.
class Writer {
public:
    /// @param upright  letters are set so by whoever takes the result
    explicit Writer(std::string_view markup, bool upright = false) : markup_(markup), upright_(upright) {}

    std::string run() {
        while (at_ < markup_.size()) { write_atom(); }
        return trimmed(latex_);
    }

private:
    std::string_view rest() const { return markup_.substr(at_); }

    void write_atom() {
        if (rest().starts_with(",  ")) {
            latex_ += ",\\quad ";
            at_ += 3;
            return;
        }
        if (rest().starts_with(' ') && latex_.ends_with(' ')) {
            ++at_;
            return;
        }
        const std::string accent = read_accent();
        const bool bold = !accent.empty() || rest().starts_with('@');
        if (rest().starts_with('@')) { ++at_; }
        std::string nucleus = read_nucleus(bold);
        if (!accent.empty()) { nucleus = accent + "{" + nucleus + "}"; }
        latex_ += nucleus + read_scripts();
    }

    /// Over a bold letter.
    std::string read_accent() {
        constexpr std::array accents{Symbol{"~", "\\tilde"}, Symbol{"˙", "\\dot"}, Symbol{"¨", "\\ddot"}};
        const Symbol* const found = symbol_at(accents, rest());
        if (found == nullptr) { return {}; }
        at_ += found->utf8.size();
        return std::string(found->latex);
    }

    /// A letter, a word, a number or an operator.
    std::string read_nucleus(bool bold) {
        if (const Symbol* const symbol = symbol_at(kSymbols, rest())) {
            at_ += symbol->utf8.size();
            return bold ? "\\boldsymbol{" + trimmed(symbol->latex) + "}" : std::string(symbol->latex);
        }
        if (bold) {
            const char c = markup_[at_++];
            const bool upright = std::isupper(static_cast<unsigned char>(c)) != 0 ||
                                 std::isdigit(static_cast<unsigned char>(c)) != 0;
            return std::string(upright ? "\\mathbf{" : "\\boldsymbol{") + c + "}";
        }
        return read_word();
    }

    std::string read_word() {
        std::size_t end = at_;
        while (end < markup_.size() && is_word(markup_[end])) { ++end; }
        if (end == at_) { return std::string(1, markup_[at_++]); }
        const std::string word(markup_.substr(at_, end - at_));
        at_ = end;
        const bool number = std::ranges::all_of(
            word, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
        if (word == "cos" || word == "sin") { return "\\" + word + " "; }
        return upright_ || word.size() == 1 || number ? word : "\\mathrm{" + word + "}";
    }

    /// All marks of one letter at once: LaTeX allows one ^ and one _ each.
    std::string read_scripts() {
        std::string below;
        std::string above;
        while (at_ < markup_.size()) {
            constexpr std::string_view prime = "′";
            if (rest().starts_with(prime)) {
                above += "\\prime ";
                at_ += prime.size();
            } else if (rest().starts_with('_') || rest().starts_with('^')) {
                std::string& target = rest().starts_with('_') ? below : above;
                ++at_;
                target += read_group();
            } else {
                break;
            }
        }
        return (below.empty() ? "" : "_{" + trimmed(below) + "}") +
               (above.empty() ? "" : "^{" + trimmed(above) + "}");
    }

    /// One character or {group}; an open group reaches to the end.
    std::string read_group() {
        if (rest().empty()) { return {}; }
        if (!rest().starts_with('{')) {
            if (rest().starts_with('T')) {
                ++at_;
                return "\\mathsf{T}";
            }
            if (const Symbol* const symbol = symbol_at(kSymbols, rest())) {
                at_ += symbol->utf8.size();
                return std::string(symbol->latex);
            }
            return std::string(1, markup_[at_++]);
        }
        const std::size_t end = std::min(markup_.find('}', at_), markup_.size());
        const std::string_view group = markup_.substr(at_ + 1, end - at_ - 1);
        at_ = std::min(end + 1, markup_.size());
        const bool upright = group.starts_with('(');
        const std::string inner = Writer(group, upright).run();
        return upright ? "\\mathrm{" + inner + "}" : inner;
    }

    std::string_view markup_;
    bool upright_;
    std::size_t at_ = 0;
    std::string latex_;
};

}  // namespace

std::string latex_of(const std::string& markup) { return Writer(markup).run(); }

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
        // a prime is a mark of nothing here
        const bool prime = symbol->utf8 == "′";
        latex += "$" + (prime ? std::string("{}^{\\prime}") : trimmed(symbol->latex)) + "$";
        rest.remove_prefix(symbol->utf8.size());
    }
    return latex;
}

}  // namespace jw
