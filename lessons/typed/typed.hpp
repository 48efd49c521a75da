#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "core/numerics/linear.hpp"

/// Conversions from what is typed in a lesson to what the program computes with; the reader applies them and
/// the writer must undo them exactly.
namespace jw {

/// Largest number that is accepted as a length, an angle or a time.
inline constexpr double kLargestNumber = 1e9;

/// Largest deviation of Euler parameters from unit length: those typed with four digits are off by 1e-4; a
/// larger deviation is a mistake.
inline constexpr double kUnitP = 1e-3;

inline double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
inline double omega_of_frequency(double hertz) { return (2.0 * std::numbers::pi) * hertz; }
/// Advance per radian [m/rad] from the advance per turn [m].
inline double alpha_of_pitch(double pitch) { return pitch / (2.0 * std::numbers::pi); }

// deviation from unit length or from a right angle after several roundings
inline constexpr double kUnitUpToRounding = 64.0 * std::numeric_limits<double>::epsilon();

/// `v` normalised. A unit vector stays unchanged, digit for digit: normalising it again would change the last
/// digit each time a lesson is written and read.
inline Vec3 unit_of(const Vec3& v) {
    return std::abs(v.squaredNorm() - 1.0) <= kUnitUpToRounding ? v : Vec3(v.normalized());
}

/// True if the columns are a right-handed frame up to rounding.
inline bool is_frame(const Mat3& A) {
    return (A.transpose() * A - Mat3::Identity()).cwiseAbs().maxCoeff() <= kUnitUpToRounding &&
           A.determinant() > 0.0;
}

// by the index of a coordinate
inline constexpr std::array<std::string_view, 7> kCoordinates{"x", "y", "z", "e0", "e1", "e2", "e3"};

/// Colours by name, sRGB.
struct NamedColour {
    std::string_view name;
    unsigned rgb;  ///< 0xrrggbb
};
inline constexpr std::array<NamedColour, 8> kNamedColours{{
    {"blue", 0x2F78B7},
    {"orange", 0xE08E1A},
    {"green", 0x1F9A76},
    {"sky", 0x5FB3E0},
    {"yellow", 0xE3C93C},
    {"vermilion", 0xCF5A1C},
    {"purple", 0xB9709E},
    {"steel", 0x8A94A0},
}};

}  // namespace jw
