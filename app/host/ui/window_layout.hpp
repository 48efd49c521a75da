#pragma once

#include "app/panels/frame/frame.hpp"

namespace jw::host {

/// The parts of the window: a frame of panels with tabs above its column, and the timeline below.
struct WindowLayout : panels::FrameLayout {
    int width = 0;  ///< pixels of the framebuffer
    int height = 0;
    float density = 0.0F;  ///< of the screen, see panels::Looking
    panels::Box whole;
};

/// @param scale  of text
WindowLayout window_layout(int width, int height, float density, float scale);

}  // namespace jw::host
