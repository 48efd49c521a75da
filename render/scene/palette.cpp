#include "render/scene/palette.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace jw::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Lightness of white paper and of black ink in the dark tone: neither dazzles nor disappears in the black of
// a projector.
constexpr double kDarkest = 0.20;
constexpr double kLightest = 0.96;
// Lifts the values between: equal steps of lightness are harder to distinguish on dark ground.
constexpr double kLift = 0.70;

double linear_from_srgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double srgb_from_linear(double c) {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

Vector3d linear_of(const Colour& colour) {
    const auto channel = [](float c) { return linear_from_srgb(static_cast<double>(c)); };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

// OKLab: B. Ottosson, "A perceptual color space for image processing", 2020
const Matrix3d kConesFromLinear{
    {0.4122214708, 0.5363325363, 0.0514459929},
    {0.2119034982, 0.6806995451, 0.1073969566},
    {0.0883024619, 0.2817188376, 0.6299787005}};
const Matrix3d kLabFromCones{
    {0.2104542553, 0.7936177850, -0.0040720468},
    {1.9779984951, -2.4285922050, 0.4505937099},
    {0.0259040371, 0.7827717662, -0.8086757660}};

Vector3d oklab_from_linear(const Vector3d& rgb) {
    return kLabFromCones * (kConesFromLinear * rgb).unaryExpr([](double c) { return std::cbrt(c); });
}

Vector3d linear_from_oklab(const Vector3d& lab) {
    static const Matrix3d cones_from_lab = kLabFromCones.inverse();
    static const Matrix3d linear_from_cones = kConesFromLinear.inverse();
    return linear_from_cones * (cones_from_lab * lab).array().cube().matrix();
}

bool in_gamut(const Vector3d& linear) { return linear.minCoeff() >= 0.0 && linear.maxCoeff() <= 1.0; }

/// The colour of this lightness and hue with the nearest chroma that a screen can show.
Vector3d shown(const Vector3d& lab) {
    const Vector3d linear = linear_from_oklab(lab);
    if (in_gamut(linear)) { return linear; }
    double grey = 1.0;
    double full = 0.0;  // share of the chroma that is removed
    for (int halving = 0; halving < 12; ++halving) {
        const double middle = 0.5 * (grey + full);
        const Vector3d paler{lab.x(), lab.y() * (1.0 - middle), lab.z() * (1.0 - middle)};
        (in_gamut(linear_from_oklab(paler)) ? grey : full) = middle;
    }
    const Vector3d found{lab.x(), lab.y() * (1.0 - grey), lab.z() * (1.0 - grey)};
    return linear_from_oklab(found).cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace

Colour toned(const Colour& colour, Tone tone) {
    if (tone == Tone::light) { return colour; }
    Vector3d lab = oklab_from_linear(linear_of(colour));
    const double dark = std::clamp(1.0 - lab.x(), 0.0, 1.0);
    lab.x() = kDarkest + (kLightest - kDarkest) * std::pow(dark, kLift);
    const Vector3d linear = shown(lab);
    const auto channel = [](double c) { return static_cast<float>(srgb_from_linear(c)); };
    return {channel(linear.x()), channel(linear.y()), channel(linear.z()), colour.a};
}

}  // namespace jw::render
