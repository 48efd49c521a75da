#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Colours of every picture: based on Okabe and Ito, so that the eight hues can be distinguished with all
/// common kinds of colour vision; slightly muted, so that large areas are not glaring on a projector.
namespace jw::render {

/// sRGB, 0 to 1; alpha is not premultiplied.
struct Colour {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;

    constexpr bool operator==(const Colour&) const = default;
};

/// 0xRRGGBB as on any colour chart.
constexpr Colour from_hex(std::uint32_t rgb, float alpha = 1.0F) {
    const auto channel = [rgb](unsigned shift) {
        return static_cast<float>((rgb >> shift) & 0xFFU) / 255.0F;
    };
    return {channel(16), channel(8), channel(0), alpha};
}

constexpr Colour with_alpha(Colour colour, float alpha) { return {colour.r, colour.g, colour.b, alpha}; }

/// `amount` 0 gives `a`, 1 gives `b`.
constexpr Colour mix(Colour a, Colour b, float amount) {
    const auto blend = [amount](float from, float to) { return from + amount * (to - from); };
    return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b), blend(a.a, b.a)};
}

namespace palette {

// hues of bodies
inline constexpr Colour kBlue = from_hex(0x2F78B7);
inline constexpr Colour kOrange = from_hex(0xE08E1A);
inline constexpr Colour kGreen = from_hex(0x1F9A76);
inline constexpr Colour kPurple = from_hex(0xB9709E);
inline constexpr Colour kSky = from_hex(0x5FB3E0);
inline constexpr Colour kVermilion = from_hex(0xCF5A1C);
inline constexpr Colour kYellow = from_hex(0xE3C93C);
inline constexpr Colour kSteel = from_hex(0x8A94A0);

/// Bodies without their own colour take these in order.
inline constexpr std::array kBodies{kBlue, kOrange, kGreen, kPurple, kSky, kVermilion, kYellow};

constexpr Colour body(std::size_t index) { return kBodies[index % kBodies.size()]; }

// colours of vectors, the same in 3D, in formulas and in tables
inline constexpr Colour kVectorI = from_hex(0x0B5FA5);  ///< s_i, u_i, h_i: fixed in body i
inline constexpr Colour kVectorJ = from_hex(0xC2410C);  ///< s_j, u_j, h_j: fixed in body j
inline constexpr Colour kVectorD = from_hex(0x0F7A5C);  ///< d, from body i to body j
inline constexpr Colour kPoint = from_hex(0x1F2933);    ///< P, B and other marked points
inline constexpr Colour kHighlight = from_hex(0xE3A008);

// axes of frames: x, y, z
inline constexpr std::array kAxes{from_hex(0xC8442F), from_hex(0x3F9142), from_hex(0x3B6FC4)};

// paper and ink
inline constexpr Colour kInk = from_hex(0x1F2933);
inline constexpr Colour kInkSoft = from_hex(0x52606D);
inline constexpr Colour kInkFaint = from_hex(0x9AA5B1);
inline constexpr Colour kLine = from_hex(0xD8DEE6);
inline constexpr Colour kPaper = from_hex(0xFDFCFA);
inline constexpr Colour kPaperShade = from_hex(0xF3F2EE);
inline constexpr Colour kBad = from_hex(0xC2410C);

// picture
inline constexpr Colour kSkyTop = from_hex(0xE9EEF3);
inline constexpr Colour kSkyBottom = from_hex(0xFBFAF7);
inline constexpr Colour kGroundBody = from_hex(0x9FA8B2);
inline constexpr Colour kGroundPlane = from_hex(0xF1EFEA);
inline constexpr Colour kGroundLine = from_hex(0xC9CCCF);
inline constexpr Colour kGroundShadow = from_hex(0x6B7683, 0.55F);

}  // namespace palette

/// Dark ink on light paper, or the other way round.
enum class Tone { light, dark };

/// Colour of the palette in a tone. The light tone does not change it; the dark tone inverts its lightness
/// and keeps hue and, where a screen can show it, chroma.
Colour toned(const Colour& colour, Tone tone);

}  // namespace jw::render
