#include "app/host/ui/window_layout.hpp"

namespace jw::host {

WindowLayout window_layout(int width, int height, float density, float scale) {
    const panels::Box whole{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    return {
        panels::layout_in(whole, panels::FrameKind::window, scale, density), width, height, density, whole};
}

}  // namespace jw::host
