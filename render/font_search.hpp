#pragma once

#include <array>

#include "render/font_face.hpp"

/// Which fonts the program needs, and where they are looked for: the folders of JOINTWISE_FONTS
/// (colon-separated), then where Debian's packages put them.
namespace jw::render {

struct FontFile {
    const char* name;
    const char* package;  ///< of Debian
};

inline constexpr FontFile kSans{"DejaVuSans.ttf", "fonts-dejavu-core"};
inline constexpr FontFile kSansBold{"DejaVuSans-Bold.ttf", "fonts-dejavu-core"};
inline constexpr FontFile kMono{"DejaVuSansMono.ttf", "fonts-dejavu-core"};
inline constexpr FontFile kMath{"latinmodern-math.otf", "fonts-lmodern"};
inline constexpr std::array kFontFiles{kSans, kSansBold, kMono, kMath};
/// What DejaVu lacks, above all Chinese. Nothing but texts with such characters needs it.
inline constexpr FontFile kChinese{"DroidSansFallbackFull.ttf", "fonts-droid-fallback"};

/// @throws std::runtime_error if the font is missing or damaged, with what to do
FontFace open_font(const FontFile& file);
/// Empty if it is in none of the folders.
std::filesystem::path path_of_font(const FontFile& file);

}  // namespace jw::render
