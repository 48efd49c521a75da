#include "app/session/output/export.hpp"

#include "app/session/output/csv.hpp"
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

}  // namespace jw
