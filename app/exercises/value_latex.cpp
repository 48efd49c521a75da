#include "app/exercises/value_latex.hpp"

#include <cmath>
#include <functional>

#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

// more digits than the tightest tolerance asks for
constexpr int kShownDigits = 6;
/// Denominator of A if Euler parameters have the denominator 15; larger ones are not easier to read than
/// decimals.
constexpr int kLargestDenominator = 225;
/// Numbers are computed to about 1e-15; other decimals are unlikely to come so near to a fraction.
constexpr double kRounding = 1e-10;

std::string written_with(const MatrixX& value, const std::function<std::string(double)>& entry) {
    if (value.size() == 1) { return entry(value(0, 0)); }
    std::string text = "\\begin{bmatrix} ";
    for (Eigen::Index r = 0; r < value.rows(); ++r) {
        if (r > 0) { text += " \\\\ "; }
        for (Eigen::Index c = 0; c < value.cols(); ++c) { text += (c > 0 ? " & " : "") + entry(value(r, c)); }
    }
    return text + " \\end{bmatrix}";
}

bool ends_as_decimal(int denominator) {
    for (const int prime : {2, 5}) {
        while (denominator % prime == 0) { denominator /= prime; }
    }
    return denominator == 1;
}

/// The smallest denominator with which all entries are fractions; 0 if there is none.
int common_denominator(const MatrixX& value) {
    if (!value.allFinite()) { return 0; }
    for (int d = 1; d <= kLargestDenominator; ++d) {
        const MatrixX numerators = value * d;
        const MatrixX off = numerators - numerators.array().round().matrix();
        if (off.cwiseAbs().maxCoeff() < kRounding * d) { return d; }
    }
    return 0;
}

std::string fraction_latex(const MatrixX& value, int denominator) {
    const auto numerator = [&](double entry) { return std::to_string(std::lround(entry * denominator)); };
    if (value.size() > 1) {
        return "\\frac{1}{" + std::to_string(denominator) + "} " + written_with(value, numerator);
    }
    const std::string sign = value(0, 0) < 0.0 ? "-" : "";
    return sign + "\\frac{" + numerator(std::abs(value(0, 0))) + "}{" + std::to_string(denominator) + "}";
}

}  // namespace

/// In a formula, "1e-05" would be read as 1 times e minus 05.
std::string number_latex(double value) {
    const std::string text = number_text(value, kShownDigits);
    const std::size_t at = text.find('e');
    if (at == std::string::npos) { return text; }
    return text.substr(0, at) + " \\cdot 10^{" + std::to_string(std::stoi(text.substr(at + 1))) + "}";
}

std::string value_latex(const MatrixX& value) { return written_with(value, number_latex); }

std::string given_latex(const GivenSymbol& symbol) {
    const int denominator = common_denominator(symbol.value);
    const bool as_fraction = denominator > 0 && !ends_as_decimal(denominator);
    return symbol.latex + " = " +
           (as_fraction ? fraction_latex(symbol.value, denominator) : value_latex(symbol.value));
}

}  // namespace jw
