#include "app/host/ui/scaled_fonts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

/// Eighths: a window that is being resized does not build fonts for every pixel.
float in_eighths(float scale) {
    return std::max(0.5F, std::floor(std::clamp(scale, 0.5F, 3.0F) * 8.0F + 0.01F) / 8.0F);
}

}  // namespace

bool ScaledFonts::fit(float scale) const { return version_ > 0 && in_eighths(scale) == fonts_.scale; }

std::string ScaledFonts::load(float scale) {
    try {
        fonts_ = render::load_fonts(in_eighths(scale));
    } catch (const std::runtime_error& error) {
        if (version_ == 0) { throw; }
        return tr("The text size stays as it is: {0}", error.what());
    }
    ++version_;
    return {};
}

}  // namespace jw::host
