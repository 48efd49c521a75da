#pragma once

#include <array>

#include "render/fonts/font_face.hpp"

/// Which fonts the program needs, and where they are searched for: in the folders of JOINTWISE_FONTS
/// (colon-separated), then where Debian's packages install them.
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
/// Characters that DejaVu does not have, above all Chinese. Only texts with such characters need it.
inline constexpr FontFile kChinese{"DroidSansFallbackFull.ttf", "fonts-droid-fallback"};

/// @throws std::runtime_error with a remedy if the font is missing or damaged
FontFace open_font(const FontFile& file);
/// Path of a font; empty if it is in none of the folders.
std::filesystem::path path_of_font(const FontFile& file);

}  // namespace jw::render
