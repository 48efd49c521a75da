#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "render/fonts/fonts.hpp"

namespace jw::host {

/// render::load_fonts, or a function that has loaded the same fonts before.
using FontLoader = std::function<render::Fonts(float scale, std::u32string_view others, render::AtlasSize)>;

/// The fonts of the interface, for one size of the window at a time.
class ScaledFonts {
public:
    explicit ScaledFonts(FontLoader loader) : loader_(std::move(loader)) {}

    /// Announces text with these characters. Those that the interface has anyway cost nothing.
    void need(std::u32string_view characters);
    /// True if the loaded fonts are those for this scale, with all characters that are needed.
    bool fit(float scale) const;
    bool lack_characters() const { return lacks_characters_; }
    /// Loads the fonts for another scale; call it between two frames of the current ImGui context.
    /// @return message that they cannot be loaded, so that the old ones stay; empty if they were loaded
    /// @throws std::runtime_error as render::load_fonts if there are no old ones
    std::string load(float scale, render::AtlasSize atlas);

    /// The needed characters beyond those of the interface.
    const std::set<char32_t>& needed() const { return needed_; }
    const render::Fonts& fonts() const { return fonts_; }
    float scale() const { return fonts_.scale; }
    /// Grows when the font atlas was built again: its texture must then be built again too.
    int version() const { return version_; }

private:
    FontLoader loader_;
    render::Fonts fonts_;
    std::set<char32_t> needed_;
    bool lacks_characters_ = false;
    int version_ = 0;
};

}  // namespace jw::host
