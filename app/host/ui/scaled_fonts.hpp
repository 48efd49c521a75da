#pragma once

#include <string>

#include "render/fonts.hpp"

namespace jw::host {

/// The letters of the interface, for one size of the window at a time.
class ScaledFonts {
public:
    /// True if the loaded fonts are those for this scale.
    bool fit(float scale) const;
    /// Loads those for another scale, between two frames of the current ImGui context.
    /// @return why they cannot be loaded, for people: the letters that are there stay; else empty
    /// @throws std::runtime_error as render::load_fonts where there are none yet
    std::string load(float scale);

    const render::Fonts& fonts() const { return fonts_; }
    float scale() const { return fonts_.scale; }
    /// Grows when the font atlas was built anew: its texture must be too.
    int version() const { return version_; }

private:
    render::Fonts fonts_;
    int version_ = 0;
};

}  // namespace jw::host
