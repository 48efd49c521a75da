#include <algorithm>
#include <cctype>

#include "core/numerics/variants.hpp"
#include "lessons/math/symbols.hpp"
#include "lessons/math/write_math.hpp"

namespace jw::math {

namespace {

bool is_capital_or_digit(const std::string& utf8) {
    const auto c = static_cast<unsigned char>(utf8.front());
    return utf8.size() == 1 && (std::isupper(c) != 0 || std::isdigit(c) != 0);
}

/// A sign as it is typed: a command or a character.
std::string typed(const Sign& sign) {
    const Symbol* const symbol = symbol_of_character(sign.utf8);
    if (symbol != nullptr) { return std::string(symbol->command); }
    return sign.kind == SignKind::function ? "\\operatorname{" + sign.utf8 + "}" : sign.utf8;
}

std::string sign_latex(const Sign& sign) {
    const bool styled = sign.kind == SignKind::letter || sign.kind == SignKind::number;
    if (!styled || sign.alphabet == Alphabet::italic) { return typed(sign); }
    if (sign.alphabet == Alphabet::upright) { return "\\mathrm{" + typed(sign) + "}"; }
    return (is_capital_or_digit(sign.utf8) ? "\\mathbf{" : "\\boldsymbol{") + typed(sign) + "}";
}

std::string typed_delimiter(const std::string& drawn) {
    return std::string(std::ranges::find(kDelimiters, drawn, &Delimiter::drawn)->typed);
}

std::string matrix_latex(const Matrix& matrix) {
    const std::string name(environment_of(matrix.kind).name);
    std::string latex = "\\begin{" + name + "}";
    for (std::size_t r = 0; r < matrix.rows.size(); ++r) {
        latex += r == 0 ? " " : " \\\\ ";
        for (std::size_t c = 0; c < matrix.rows[r].size(); ++c) {
            latex += (c == 0 ? "" : " & ") + write_latex(matrix.rows[r][c]);
        }
    }
    return latex + " \\end{" + name + "}";
}

std::string space_latex(double em) {
    const auto found = std::ranges::find(kSpaces, em, &SpaceCommand::em);
    return found == kSpaces.end() ? "~" : std::string(found->command);
}

std::string nucleus_latex(const Node& node) {
    return std::visit(
        Overloaded{
            [](const Sign& sign) { return sign_latex(sign); },
            [](const Words& words) { return "\\text{" + words.utf8 + "}"; },
            [](const Space& space) { return space_latex(space.em); },
            [](const Fraction& f) {
                return "\\frac{" + write_latex(f.above) + "}{" + write_latex(f.below) + "}";
            },
            [](const Root& root) { return "\\sqrt{" + write_latex(root.inner) + "}"; },
            [](const Accent& a) {
                return std::string(accent_of(a.kind).command) + "{" + write_latex(a.inner) + "}";
            },
            [](const Group& g) {
                if (g.open.empty() && g.close.empty()) { return "{" + write_latex(g.inner) + "}"; }
                return "\\left" + typed_delimiter(g.open) + " " + write_latex(g.inner) + " \\right" +
                       typed_delimiter(g.close);
            },
            [](const Matrix& matrix) { return matrix_latex(matrix); },
        },
        node.nucleus);
}

/// A superscript: the transpose is a sans-serif T, names like (p1,2) are upright.
std::string superscript_latex(const Row& above) {
    if (above.size() == 1 && is_sign(above[0], "T")) { return "\\mathsf{T}"; }
    if (above.empty() || !is_sign(above.front(), "(")) { return write_latex(above); }
    Row plain = above;
    for (Node& node : plain) {
        if (auto* const sign = std::get_if<Sign>(&node.nucleus)) { sign->alphabet = Alphabet::italic; }
    }
    return "\\mathrm{" + write_latex(plain) + "}";
}

bool ends_with_command(const std::string& latex) {
    std::size_t at = latex.size();
    while (at > 0 && std::isalpha(static_cast<unsigned char>(latex[at - 1])) != 0) { --at; }
    return at > 0 && at < latex.size() && latex[at - 1] == '\\';
}

}  // namespace

std::string write_latex(const Row& row) {
    std::string latex;
    for (const Node& node : row) {
        std::string written = nucleus_latex(node);
        if (!node.below.empty()) { written += "_{" + write_latex(node.below) + "}"; }
        if (!node.above.empty()) { written += "^{" + superscript_latex(node.above) + "}"; }
        const bool spaced = is_kind(node, SignKind::relation) || is_kind(node, SignKind::operation);
        const bool letter_next = std::isalpha(static_cast<unsigned char>(written.front())) != 0;
        const bool after = !latex.empty() && !latex.ends_with(' ');
        if (after && (spaced || (letter_next && ends_with_command(latex)))) { latex += ' '; }
        latex += written;
        if (spaced) { latex += ' '; }
    }
    while (latex.ends_with(' ') && !latex.ends_with("\\ ")) { latex.pop_back(); }
    return latex;
}

}  // namespace jw::math
