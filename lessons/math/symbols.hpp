#pragma once

#include <array>
#include <string_view>

#include "lessons/math/math.hpp"

/// The commands of the notation; docs/mathematics.md lists them, and a test compares both lists.
namespace jw::math {

/// A command that stands for one sign.
struct Symbol {
    std::string_view command;  ///< "\\alpha"
    std::string_view utf8;     ///< "α"
    SignKind kind = SignKind::letter;
};
inline constexpr std::array kSymbols = [] {
    using enum SignKind;
    return std::array{
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
}();

/// Symbol of a command, or of a character that may be typed directly; nullptr if there is none.
const Symbol* symbol_of_command(std::string_view command);
const Symbol* symbol_of_character(std::string_view utf8);

/// A command that puts something over its argument.
struct AccentCommand {
    std::string_view command;  ///< "\\tilde"
    AccentKind kind = AccentKind::tilde;
    std::string_view combining;  ///< character that stands over the one before it
    std::string_view over;       ///< the same as a separate sign, for MathML
};
inline constexpr std::array kAccents{
    AccentCommand{"\\tilde", AccentKind::tilde, "\u0303", "~"},
    AccentCommand{"\\dot", AccentKind::dot, "\u0307", "˙"},
    AccentCommand{"\\ddot", AccentKind::two_dots, "\u0308", "¨"},
    AccentCommand{"\\bar", AccentKind::bar, "\u0304", "¯"},
    AccentCommand{"\\hat", AccentKind::hat, "\u0302", "^"},
    AccentCommand{"\\vec", AccentKind::arrow, "\u20D7", "→"},
};
const AccentCommand& accent_of(AccentKind kind);

/// \begin{name} ... \end{name}
struct Environment {
    std::string_view name;  ///< "bmatrix"
    MatrixKind kind = MatrixKind::brackets;
    std::string_view open;  ///< delimiters
    std::string_view close;
};
inline constexpr std::array kEnvironments{
    Environment{"bmatrix", MatrixKind::brackets, "[", "]"},
    Environment{"pmatrix", MatrixKind::parentheses, "(", ")"},
    Environment{"vmatrix", MatrixKind::bars, "|", "|"},
    Environment{"matrix", MatrixKind::plain, "", ""},
    Environment{"cases", MatrixKind::cases, "{", ""},
};
const Environment& environment_of(MatrixKind kind);

/// \quad and the like.
struct SpaceCommand {
    std::string_view command;
    double em = 0.0;
};
inline constexpr std::array kSpaces{
    SpaceCommand{"\\quad", 1.0}, SpaceCommand{"\\qquad", 2.0}, SpaceCommand{"\\,", 0.17},
    SpaceCommand{"\\;", 0.28},   SpaceCommand{"\\!", -0.17},
};

/// Commands with one argument that choose letters: \mathbf, \boldsymbol, \mathrm.
struct AlphabetCommand {
    std::string_view command;
    Alphabet alphabet = Alphabet::bold;
};
inline constexpr std::array kAlphabets{
    AlphabetCommand{"\\mathbf", Alphabet::bold},
    AlphabetCommand{"\\boldsymbol", Alphabet::bold},
    AlphabetCommand{"\\mathrm", Alphabet::upright},
    AlphabetCommand{"\\mathsf", Alphabet::upright},
};

/// Delimiters that \left and \right take, as typed and as drawn; "." draws nothing.
struct Delimiter {
    std::string_view typed;
    std::string_view drawn;
};
inline constexpr std::array kDelimiters{
    Delimiter{"(", "("},       Delimiter{")", ")"},       Delimiter{"[", "["}, Delimiter{"]", "]"},
    Delimiter{"\\{", "{"},     Delimiter{"\\}", "}"},     Delimiter{"|", "|"}, Delimiter{"\\|", "‖"},
    Delimiter{"\\lVert", "‖"}, Delimiter{"\\rVert", "‖"}, Delimiter{".", ""},
};

}  // namespace jw::math
