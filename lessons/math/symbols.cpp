#include "lessons/math/symbols.hpp"

#include <algorithm>
#include <array>

namespace jw::math {

namespace {

using enum SignKind;

constexpr std::array kSymbols{
    Symbol{"\\alpha", "α", letter},
    Symbol{"\\beta", "β", letter},
    Symbol{"\\gamma", "γ", letter},
    Symbol{"\\delta", "δ", letter},
    Symbol{"\\epsilon", "ϵ", letter},
    Symbol{"\\varepsilon", "ε", letter},
    Symbol{"\\zeta", "ζ", letter},
    Symbol{"\\eta", "η", letter},
    Symbol{"\\theta", "θ", letter},
    Symbol{"\\kappa", "κ", letter},
    Symbol{"\\lambda", "λ", letter},
    Symbol{"\\mu", "μ", letter},
    Symbol{"\\nu", "ν", letter},
    Symbol{"\\xi", "ξ", letter},
    Symbol{"\\pi", "π", letter},
    Symbol{"\\rho", "ρ", letter},
    Symbol{"\\sigma", "σ", letter},
    Symbol{"\\tau", "τ", letter},
    Symbol{"\\varphi", "φ", letter},
    Symbol{"\\phi", "φ", letter},
    Symbol{"\\chi", "χ", letter},
    Symbol{"\\psi", "ψ", letter},
    Symbol{"\\omega", "ω", letter},
    Symbol{"\\Gamma", "Γ", letter},
    Symbol{"\\Delta", "Δ", letter},
    Symbol{"\\Theta", "Θ", letter},
    Symbol{"\\Lambda", "Λ", letter},
    Symbol{"\\Xi", "Ξ", letter},
    Symbol{"\\Pi", "Π", letter},
    Symbol{"\\Sigma", "Σ", letter},
    Symbol{"\\Phi", "Φ", letter},
    Symbol{"\\Psi", "Ψ", letter},
    Symbol{"\\Omega", "Ω", letter},
    Symbol{"+", "+", operation},
    Symbol{"-", "−", operation},
    Symbol{"\\cdot", "·", operation},
    Symbol{"\\times", "×", operation},
    Symbol{"\\pm", "±", operation},
    Symbol{"=", "=", relation},
    Symbol{"<", "<", relation},
    Symbol{">", ">", relation},
    Symbol{"\\equiv", "≡", relation},
    Symbol{"\\approx", "≈", relation},
    Symbol{"\\ne", "≠", relation},
    Symbol{"\\neq", "≠", relation},
    Symbol{"\\le", "≤", relation},
    Symbol{"\\leq", "≤", relation},
    Symbol{"\\ge", "≥", relation},
    Symbol{"\\geq", "≥", relation},
    Symbol{"\\ll", "≪", relation},
    Symbol{"\\to", "→", relation},
    Symbol{"\\rightarrow", "→", relation},
    Symbol{"\\Rightarrow", "⇒", relation},
    Symbol{"\\Leftrightarrow", "⇔", relation},
    Symbol{"\\in", "∈", relation},
    Symbol{"\\parallel", "∥", relation},
    Symbol{"\\perp", "⊥", relation},
    Symbol{":", ":", relation},
    Symbol{"(", "(", opening},
    Symbol{"[", "[", opening},
    Symbol{"\\{", "{", opening},
    Symbol{")", ")", closing},
    Symbol{"]", "]", closing},
    Symbol{"\\}", "}", closing},
    Symbol{"|", "|", fence},
    Symbol{"\\|", "‖", fence},
    Symbol{"\\lVert", "‖", fence},
    Symbol{"\\rVert", "‖", fence},
    Symbol{",", ",", punctuation},
    Symbol{";", ";", punctuation},
    Symbol{".", ".", punctuation},
    Symbol{"\\sum", "∑", large},
    Symbol{"\\int", "∫", large},
    Symbol{"\\prime", "′", ordinary},
    Symbol{"\\partial", "∂", ordinary},
    Symbol{"\\infty", "∞", ordinary},
    Symbol{"\\ldots", "…", ordinary},
    Symbol{"\\dots", "…", ordinary},
    Symbol{"\\cdots", "⋯", ordinary},
    Symbol{"\\vdots", "⋮", ordinary},
    Symbol{"\\ddots", "⋱", ordinary},
    Symbol{"\\#", "#", ordinary},
    Symbol{"\\%", "%", ordinary},
    Symbol{"\\circ", "°", ordinary},
    Symbol{"/", "/", ordinary},
    Symbol{"!", "!", ordinary},
    Symbol{"?", "?", ordinary},
    Symbol{"\\sin", "sin", function},
    Symbol{"\\cos", "cos", function},
    Symbol{"\\tan", "tan", function},
    Symbol{"\\arctan", "arctan", function},
    Symbol{"\\arccos", "arccos", function},
    Symbol{"\\arcsin", "arcsin", function},
    Symbol{"\\exp", "exp", function},
    Symbol{"\\ln", "ln", function},
    Symbol{"\\det", "det", function},
    Symbol{"\\max", "max", function},
    Symbol{"\\min", "min", function},
};

constexpr std::array kAccents{
    AccentCommand{"\\tilde", AccentKind::tilde, "\u0303", "~"},
    AccentCommand{"\\dot", AccentKind::dot, "\u0307", "˙"},
    AccentCommand{"\\ddot", AccentKind::two_dots, "\u0308", "¨"},
    AccentCommand{"\\bar", AccentKind::bar, "\u0304", "¯"},
    AccentCommand{"\\hat", AccentKind::hat, "\u0302", "^"},
    AccentCommand{"\\vec", AccentKind::arrow, "\u20D7", "→"},
};

constexpr std::array kEnvironments{
    Environment{"bmatrix", MatrixKind::brackets, "[", "]"},
    Environment{"pmatrix", MatrixKind::parentheses, "(", ")"},
    Environment{"vmatrix", MatrixKind::bars, "|", "|"},
    Environment{"matrix", MatrixKind::plain, "", ""},
    Environment{"cases", MatrixKind::cases, "{", ""},
};

constexpr std::array kSpaces{
    SpaceCommand{"\\quad", 1.0}, SpaceCommand{"\\qquad", 2.0}, SpaceCommand{"\\,", 0.17},
    SpaceCommand{"\\;", 0.28},   SpaceCommand{"\\!", -0.17},
};

constexpr std::array kAlphabets{
    AlphabetCommand{"\\mathbf", Alphabet::bold},
    AlphabetCommand{"\\boldsymbol", Alphabet::bold},
    AlphabetCommand{"\\mathrm", Alphabet::upright},
    AlphabetCommand{"\\mathsf", Alphabet::upright},
};

constexpr std::array kDelimiters{
    Delimiter{"(", "("},       Delimiter{")", ")"},       Delimiter{"[", "["}, Delimiter{"]", "]"},
    Delimiter{"\\{", "{"},     Delimiter{"\\}", "}"},     Delimiter{"|", "|"}, Delimiter{"\\|", "‖"},
    Delimiter{"\\lVert", "‖"}, Delimiter{"\\rVert", "‖"}, Delimiter{".", ""},
};

}  // namespace

std::span<const Symbol> symbols() { return kSymbols; }
std::span<const AccentCommand> accents() { return kAccents; }
std::span<const Environment> environments() { return kEnvironments; }
std::span<const SpaceCommand> spaces() { return kSpaces; }
std::span<const AlphabetCommand> alphabets() { return kAlphabets; }
std::span<const Delimiter> delimiters() { return kDelimiters; }

const Symbol* symbol_of_command(std::string_view command) {
    const auto found = std::ranges::find(kSymbols, command, &Symbol::command);
    return found == kSymbols.end() ? nullptr : &*found;
}

const Symbol* symbol_of_character(std::string_view utf8) {
    const auto found = std::ranges::find(kSymbols, utf8, &Symbol::utf8);
    return found == kSymbols.end() ? nullptr : &*found;
}

const AccentCommand& accent_of(AccentKind kind) {
    return *std::ranges::find(kAccents, kind, &AccentCommand::kind);
}

const Environment& environment_of(MatrixKind kind) {
    return *std::ranges::find(kEnvironments, kind, &Environment::kind);
}

bool is_sign(const Node& node, const char* utf8) {
    const Sign* const sign = std::get_if<Sign>(&node.nucleus);
    return sign != nullptr && sign->utf8 == utf8;
}

bool is_kind(const Node& node, SignKind kind) {
    const Sign* const sign = std::get_if<Sign>(&node.nucleus);
    return sign != nullptr && sign->kind == kind;
}

}  // namespace jw::math
