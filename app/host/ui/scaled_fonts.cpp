#include "app/host/ui/scaled_fonts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

/// Rounds down to eighths, so that resizing a window does not load fonts for every pixel.
float in_eighths(float scale) {
    return std::max(0.5F, std::floor(std::clamp(scale, 0.5F, 3.0F) * 8.0F + 0.01F) / 8.0F);
}

}  // namespace

void ScaledFonts::need(std::u32string_view characters) {
    for (const char32_t c : characters) {
        if (!render::is_of_interface(c) && needed_.insert(c).second) { lacks_characters_ = true; }
    }
}

bool ScaledFonts::fit(float scale) const {
    return version_ > 0 && !lacks_characters_ && in_eighths(scale) == fonts_.scale;
}

std::string ScaledFonts::load(float scale, render::AtlasSize atlas) {
    lacks_characters_ = false;  // a failure is not tried again in every frame
    try {
        fonts_ = loader_(in_eighths(scale), std::u32string(needed_.begin(), needed_.end()), atlas);
    } catch (const std::runtime_error& error) {
        if (version_ == 0) { throw; }
        return tr("The text size stays as it is: {0}", error.what());
    }
    ++version_;
    return {};
}

}  // namespace jw::host
