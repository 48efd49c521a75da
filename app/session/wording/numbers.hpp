#pragma once

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Numbers as people read them.
namespace jw {

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// Up to `digits` significant digits; "0" below 1e-15; an exponent below 1e-4 and from 10^digits on.
std::string number_text(double value, int digits = 4);
/// Always with `decimals` decimals, for numbers that change from picture to picture.
std::string fixed_text(double value, int decimals);
/// "1.2e-07": for residuals and singular values.
std::string small_text(double value);
/// "(0.5, 0, -1)"
std::string vector_text(const Vec3& v, int digits = 4);
/// "1 equation", "3 equations"
std::string count_text(int count, const std::string& singular, const std::string& plural = {});
/// Texts of all items, separated by `between`: "a, b, c". @param text_of  text of an item
template <class Items, class TextOf = std::identity>
std::string joined(const Items& items, const std::string& between, TextOf text_of = {}) {
    std::string text;
    for (const auto& item : items) { text += (text.empty() ? "" : between) + text_of(item); }
    return text;
}

/// "a, b and c"
std::string listed(const std::vector<std::string>& items);
/// "a, b or c".
std::string alternatives(const std::vector<std::string>& items);
/// Two sentences, one after the other; either may be empty.
std::string followed(const std::string& sentence, const std::string& next);

/// "0.25", "1.2 \cdot 10^{-7}"
std::string number_markup(double value, int digits = 4);

/// A matrix in brackets; a matrix with one entry is a number. If it has more than eight rows or columns, its
/// size in words, in \text.
std::string matrix_markup(const MatrixX& values, int digits = 4);

}  // namespace jw
