#include "app/session/output/export.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "app/session/view/series.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

constexpr Eigen::Index kMostColumns = 10;  // of a bmatrix, unless amsmath is told otherwise

std::string display(const std::string& body) {
    return "\\begin{equation*}\n" + body + "\n\\end{equation*}\n";
}

/// A number in LaTeX: "-0.5", "1.2\cdot 10^{-5}"
std::string latex_number(double value) {
    const std::string text = number_text(value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) { return text; }
    return text.substr(0, e) + "\\cdot 10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
}

std::string entries_of(const MatrixX& values, Eigen::Index row) {
    std::string text;
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
        text += (k > 0 ? " & " : "") + latex_number(values(row, k));
    }
    return text;
}

/// Number of columns, from `first` on, that belong to the same body.
std::size_t columns_together(const MatrixView& matrix, std::size_t first) {
    std::size_t last = first;
    while (last < matrix.columns.size() && matrix.columns[last].owner == matrix.columns[first].owner) {
        ++last;
    }
    return last - first;
}

/// Format of the columns of an array: "ll|rrrrrrr|rrrrrrr"
std::string column_format(const MatrixView& matrix) {
    std::string format = "ll";
    for (std::size_t k = 0; k < matrix.columns.size(); k += columns_together(matrix, k)) {
        format += "|" + std::string(columns_together(matrix, k), 'r');
    }
    return format;
}

std::string in_text(const std::string& words) { return "\\text{" + latex_text(words) + "}"; }

std::string labelled_array(const MatrixView& matrix) {
    std::string owners = "&";
    std::string symbols = "&";
    for (std::size_t k = 0; k < matrix.columns.size();) {
        const std::size_t count = columns_together(matrix, k);
        const bool last = k + count == matrix.columns.size();
        owners += " & \\multicolumn{" + std::to_string(count) + "}{c" + (last ? "" : "|") + "}{" +
                  in_text(matrix.columns[k].owner) + "}";
        for (std::size_t n = 0; n < count; ++n, ++k) { symbols += " & " + in_text(matrix.columns[k].symbol); }
    }
    std::string text =
        "\\begin{array}{" + column_format(matrix) + "}\n" + owners + " \\\\\n" + symbols + " \\\\\n";
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        const bool first = row == 0 || matrix.rows[row - 1].owner != matrix.rows[row].owner;
        text += std::string(first ? "\\hline\n" : "") + (first ? in_text(matrix.rows[row].owner) : "") +
                " & " + in_text(matrix.rows[row].label);
        if (!matrix.columns.empty()) {
            text += " & " + entries_of(matrix.values, static_cast<Eigen::Index>(row));
        }
        text += " \\\\\n";
    }
    return text + "\\end{array}";
}

std::string bracketed(const MatrixView& matrix) {
    std::string text = "\\begin{bmatrix}\n";
    for (Eigen::Index row = 0; row < matrix.values.rows(); ++row) {
        text += entries_of(matrix.values, row) + " \\\\\n";
    }
    return text + "\\end{bmatrix}";
}

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

std::string equation_latex(const EquationGroup& group) {
    return display(math::write_latex(math::own_math(group.formula)));
}

std::string equations_latex(const View& view) {
    std::string text;
    for (const EquationGroup& group : view.equations) { text += equation_latex(group) + '\n'; }
    return text;
}

std::string matrix_latex(const MatrixView& matrix, MatrixStyle style) {
    const std::string name = "\\boldsymbol{\\Phi}_{\\boldsymbol{q}} = ";
    if (style == MatrixStyle::labelled) { return display(name + "\n" + labelled_array(matrix)); }
    const Eigen::Index columns = matrix.values.cols();
    const std::string more =
        columns > kMostColumns ? "\\setcounter{MaxMatrixCols}{" + std::to_string(columns) + "}\n" : "";
    return more + display(name + "\n" + bracketed(matrix));
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) { return text; }
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') { quoted += '"'; }
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_number(double value) {
    if (std::isnan(value)) { return {}; }
    char digits[32];
    const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), value);
    return {std::begin(digits), end};
}

std::string csv_of(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows) {
    std::string text;
    const auto add_line = [&](const auto& cells, const auto& cell) {
        for (std::size_t k = 0; k < cells.size(); ++k) { text += (k > 0 ? "," : "") + cell(cells[k]); }
        text += '\n';
    };
    add_line(columns, csv_cell);
    for (const std::vector<double>& row : rows) { add_line(row, csv_number); }
    return text;
}

std::string csv_of(const SeriesSet& set) {
    std::string text = csv_cell(set.axis);
    for (const Series& s : set.series) {
        text += ',' + csv_cell(s.unit == "-" ? s.name : s.name + " [" + s.unit + "]");
    }
    text += '\n';
    for (std::size_t k = 0; k < set.at.size(); ++k) {
        text += csv_number(set.at[k]);
        for (const Series& s : set.series) { text += ',' + csv_number(s.values[k]); }
        text += '\n';
    }
    return text;
}

std::string matrix_csv(const MatrixView& matrix) {
    std::string text = "belongs to,row";
    for (const MatrixView::Column& column : matrix.columns) {
        text += ',' + csv_cell(column.owner + " " + column.symbol);
    }
    text += '\n';
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        text += csv_cell(matrix.rows[row].owner) + ',' + csv_cell(matrix.rows[row].label);
        for (Eigen::Index k = 0; k < matrix.values.cols(); ++k) {
            text += ',' + csv_number(matrix.values(static_cast<Eigen::Index>(row), k));
        }
        text += '\n';
    }
    return text;
}

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
