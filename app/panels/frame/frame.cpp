#include "app/panels/frame/frame.hpp"

#include <algorithm>
#include <cmath>

#include "app/panels/column/column.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/caption.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

// parts of the frame
constexpr float kTitleHeight = 62.0F;
constexpr float kColumnPart = 0.4F;
constexpr float kCaptionPart = 0.225F;
constexpr float kMostCaptionGrowth = 1.5F;

/// Names of bodies and vectors stand around it.
render::Rect safe_part(const Box& scene, float scale) {
    return rect_of(shrunk(scene, std::round(44.0F * scale), std::round(34.0F * scale)));
}

}  // namespace

float scale_of(int width, int height) {
    return std::min(static_cast<float>(width) / 1280.0F, static_cast<float>(height) / 720.0F);
}

float scale_without_panels(int width, int height) {
    // the 3D picture in a frame of 1280x720
    return std::min(static_cast<float>(width) / 768.0F, static_cast<float>(height) / 496.0F);
}

FrameLayout layout_of(int width, int height) {
    const Box frame{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    return layout_in(frame, scale_of(width, height), 0.0F);
}

FrameLayout layout_without_panels(const Box& frame, float scale) {
    FrameLayout layout;
    layout.scene = rect_of(frame);
    layout.scene_safe = safe_part(frame, scale);
    return layout;
}

FrameLayout layout_in(const Box& frame, float scale, float tabs_height, float text) {
    Box rest = frame;
    FrameLayout layout;
    layout.title = cut_top(rest, std::round(kTitleHeight * scale));
    Box left = cut_left(rest, std::round((1.0F - kColumnPart) * frame.width));
    layout.tabs = cut_top(rest, tabs_height);
    layout.column = rest;
    const float caption = kCaptionPart * std::clamp(text, 1.0F, kMostCaptionGrowth);
    const Box scene = cut_top(left, left.height - std::round(caption * frame.height));
    layout.caption = left;
    layout.scene = rect_of(scene);
    layout.scene_safe = safe_part(scene, scale);
    return layout;
}

void draw_frame(
    const Canvas& canvas, const View& view, const Picture& picture, const render::Camera& camera,
    const FrameLayout& layout) {
    draw_annotations(canvas, picture, camera, layout.scene);
    draw_title(canvas, layout.title, view);
    draw_caption(canvas, layout.caption, view);
    draw_column(canvas, layout.column, view);
}

}  // namespace jw::panels
