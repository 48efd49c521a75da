#pragma once

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
/// "a, b and c"
std::string listed(const std::vector<std::string>& items);
/// "a, b or c".
std::string alternatives(const std::vector<std::string>& items);
/// Two sentences, one after the other; either may be empty.
std::string followed(const std::string& sentence, const std::string& next);

}  // namespace jw
