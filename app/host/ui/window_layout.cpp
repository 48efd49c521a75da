#include "app/host/ui/window_layout.hpp"

#include <cmath>

namespace jw::host {

namespace {

constexpr float kBarHeight = 56.0F;
constexpr float kTabsHeight = 36.0F;

}  // namespace

WindowLayout window_layout(int width, int height, float scale) {
    const panels::Box whole{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    const float bar = std::round(kBarHeight * scale);
    panels::Box frame = whole;
    frame.height -= bar;
    return {
        panels::layout_in(
            frame, scale, std::round(kTabsHeight * scale), scale / panels::scale_of(width, height)),
        width,
        height,
        whole,
        {0.0F, frame.height, whole.width, bar}};
}

}  // namespace jw::host
