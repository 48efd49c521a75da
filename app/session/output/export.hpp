#pragma once

#include <string>

#include "app/session/view/view.hpp"

/// Views as text for other programs: LaTeX that needs only amsmath, and comma-separated tables (RFC 4180,
/// line feeds, numbers with all digits).
namespace jw {

/// Words and labels for \text{...}: characters that are special in LaTeX are escaped, symbols are set as
/// mathematics, letters of other alphabets stay as they are.
std::string latex_text(const std::string& text);

/// An equation as its own display.
std::string equation_latex(const EquationGroup& group);
/// All equations of a step, one display each; empty if it has none.
std::string equations_latex(const View& view);

enum class MatrixStyle {
    labelled,  ///< an array with the names of rows and columns
    brackets,  ///< a bmatrix of numbers
};
/// Φq as its own display, with four digits.
std::string matrix_latex(const MatrixView& matrix, MatrixStyle style);

/// Text of a cell, quoted where needed.
std::string csv_cell(const std::string& text);

/// Shortest form that reads back as the same double; empty for NaN.
std::string csv_number(double value);

/// Table with a header and one line per row; each line ends with a line feed.
std::string csv_of(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows);

/// One line per row of Φq: its owner, its label, its entries; columns are named "crank ω′x".
std::string matrix_csv(const MatrixView& matrix);

}  // namespace jw
