#include "app/session/wording/numbers.hpp"

#include <cmath>
#include <cstdio>

#include "app/session/wording/messages.hpp"
#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

// below this a number of a scene in metres and radians is rounding
constexpr double kRounding = 1e-15;

/// "a, b" of a, b and c; a single item itself.
std::string all_but_last(const std::vector<std::string>& items) {
    std::string text = items.empty() ? "" : items.front();
    for (std::size_t k = 1; k + 1 < items.size(); ++k) { text = tr("{0}, {1}", text, items[k]); }
    return text;
}

constexpr Eigen::Index kMostEntries = 8;  ///< in a row or a column: more are not read in a tip

}  // namespace

std::string number_text(double value, int digits) {
    if (!std::isfinite(value)) { return value > 0.0 ? "∞" : (value < 0.0 ? "−∞" : "undefined"); }
    if (std::abs(value) < kRounding) { return "0"; }
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) { return number_text(value); }
    // no "-0.000"
    const double unit = elementary::pow(10.0, -decimals);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * unit ? 0.0 : value);
    return text;
}

std::string small_text(double value) {
    if (!std::isfinite(value)) { return number_text(value); }
    if (value == 0.0) { return "0"; }
    char text[64];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

std::string vector_text(const Vec3& v, int digits) {
    return "(" + number_text(v.x(), digits) + ", " + number_text(v.y(), digits) + ", " +
           number_text(v.z(), digits) + ")";
}

std::string count_text(int count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : (plural.empty() ? singular + "s" : plural));
}

std::string listed(const std::vector<std::string>& items) {
    const std::string text = all_but_last(items);
    return items.size() < 2 ? text : tr("{0} and {1}", text, items.back());
}

std::string alternatives(const std::vector<std::string>& items) {
    const std::string text = all_but_last(items);
    return items.size() < 2 ? text : tr("{0} or {1}", text, items.back());
}

std::string followed(const std::string& sentence, const std::string& next) {
    if (sentence.empty() || next.empty()) { return sentence + next; }
    return tr("{0} {1}", sentence, next);
}

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
