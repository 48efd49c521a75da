#include "app/session/wording/markup.hpp"

#include <cmath>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

constexpr Eigen::Index kMostEntries = 8;  ///< in a row or a column: more are not read in a tip

}  // namespace

std::string number_markup(double value, int digits) {
    if (std::isnan(value)) { return "\\text{" + number_text(value) + "}"; }
    if (std::isinf(value)) { return value > 0.0 ? "\\infty" : "-\\infty"; }
    const std::string text = number_text(value, digits);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) { return text; }
    return text.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
}

std::string matrix_markup(const MatrixX& values, int digits) {
    if (values.size() == 1) { return number_markup(values(0, 0), digits); }
    if (values.rows() > kMostEntries || values.cols() > kMostEntries) {
        return "\\text{" + tr("a matrix of {0} rows and {1} columns", values.rows(), values.cols()) + "}";
    }
    std::string text = "\\begin{bmatrix}";
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        text += row == 0 ? " " : " \\\\ ";
        for (Eigen::Index column = 0; column < values.cols(); ++column) {
            text += (column == 0 ? "" : " & ") + number_markup(values(row, column), digits);
        }
    }
    return text + " \\end{bmatrix}";
}

}  // namespace jw
