#include "app/panels/frame/frame.hpp"

#include <algorithm>
#include <cmath>

#include "app/panels/column/panels.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

constexpr float kTitleHeight = 62.0F;

// a column at the right
constexpr float kColumnPart = 0.4F;
constexpr float kCaptionPart = 0.225F;
constexpr float kMostCaptionGrowth = 1.5F;
constexpr float kTabsHeight = 36.0F;
constexpr float kBarHeight = 56.0F;

// least height over width of an upright frame: a book, a phone, a tablet, but not two windows side by side
constexpr float kUprightShape = 1.2F;
constexpr float kUprightWidth = 480.0F;
constexpr float kUprightHeight = 800.0F;
constexpr float kUprightTitleHeight = 84.0F;  // three lines: two texts do not fit side by side
constexpr float kMostSceneShape = 0.8F;       // largest height of the picture over its width
constexpr float kUprightScenePart = 0.39F;    // of the height that title, tabs and bar leave
constexpr float kUprightCaptionPart = 0.17F;
constexpr float kFinger = 40.0F;            // height that a finger needs, in pixels of a web page
constexpr float kUnknownDensity = 1.25F;    // relative to scale_of, as on a phone
constexpr float kUprightBarHeight = 54.0F;  // in addition to the buttons: a line to scrub on, and gaps

constexpr float kLargestText = 1.5F;  // relative to scale_of: with larger text, panels have no room
// the smallest letters, 14 pixels at scale 1, get 11 pixels in a hand, and 10 on a turned phone
constexpr float kLeastUpright = 0.8F;
constexpr float kLeastTurned = 0.72F;

constexpr float kMostMargin = 0.2F;  // around bodies, part of the picture

constexpr float kLeastOfPhones = 2.0F;  // density

/// True if letters would be too small for a hand although they are as large as the room allows.
bool is_turned_phone(float usual, float density) {
    return density >= kLeastOfPhones && kLeastTurned * density > usual;
}

bool is_upright(float width, float height) { return height >= kUprightShape * width; }

/// Part of the 3D picture in which the bodies must lie; the margin around it is for names of bodies and
/// vectors.
render::Rect safe_part(const Box& scene, float scale) {
    const auto margin = [&](float at_720, float length) {
        return std::min(std::round(at_720 * scale), kMostMargin * length);
    };
    return rect_of(shrunk(scene, margin(44.0F, scene.width), margin(34.0F, scene.height)));
}

/// Cuts a strip off the foot of `rest`.
Box cut_bottom(Box& rest, float height) {
    Box bottom = rest;
    rest = cut_top(bottom, rest.height - height);
    return bottom;
}

/// @param text  size of text relative to that of a frame of this size: the caption grows with it
FrameLayout column_at_right(const Box& frame, FrameKind kind, float scale, float text) {
    Box rest = frame;
    FrameLayout layout;
    layout.bar = cut_bottom(rest, kind == FrameKind::window ? std::round(kBarHeight * scale) : 0.0F);
    const float height = rest.height;
    layout.title = cut_top(rest, std::round(kTitleHeight * scale));
    Box left = cut_left(rest, std::round((1.0F - kColumnPart) * frame.width));
    layout.tabs = cut_top(rest, kind == FrameKind::window ? std::round(kTabsHeight * scale) : 0.0F);
    layout.column = rest;
    const float caption = kCaptionPart * std::clamp(text, 1.0F, kMostCaptionGrowth);
    const Box scene = cut_top(left, left.height - std::round(caption * height));
    layout.caption = left;
    layout.scene = rect_of(scene);
    layout.scene_safe = safe_part(scene, scale);
    return layout;
}

/// @param finger  height that a finger needs [pixels]
FrameLayout upright(const Box& frame, FrameKind kind, float scale, float finger) {
    const bool is_window = kind == FrameKind::window;
    Box rest = frame;
    FrameLayout layout;
    layout.upright = layout.for_fingers = true;
    layout.bar = cut_bottom(rest, is_window ? finger + std::round(kUprightBarHeight * scale) : 0.0F);
    layout.title = cut_top(rest, std::round(kUprightTitleHeight * scale));
    const float tabs = is_window ? finger : 0.0F;
    const float room = std::max(0.0F, rest.height - tabs);
    const float height = std::min(kUprightScenePart * room, kMostSceneShape * rest.width);
    const Box scene = cut_top(rest, std::round(height));
    layout.caption = cut_top(rest, std::round(kUprightCaptionPart * room));
    layout.tabs = cut_top(rest, tabs);
    layout.column = rest;
    layout.scene = rect_of(scene);
    layout.scene_safe = safe_part(scene, scale);
    return layout;
}

}  // namespace

float scale_of(int width, int height) {
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    return is_upright(w, h) ? std::min(w / kUprightWidth, h / kUprightHeight)
                            : std::min(w / 1280.0F, h / 720.0F);
}

float scale_on_screen(int width, int height, const Looking& looking) {
    const float usual = scale_of(width, height);
    if (looking.density <= 0.0F) { return usual * looking.text; }
    const float most = kLargestText * usual;
    const bool upright = is_upright(static_cast<float>(width), static_cast<float>(height));
    const float least = looking.density * (upright ? kLeastUpright : kLeastTurned);
    const float readable = std::max(upright ? std::min(usual, looking.density) : usual, least);
    return std::min(readable * looking.text, most);
}

float scale_without_panels(int width, int height) {
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    // 768x496 is the 3D picture in a frame of 1280x720; in an upright frame, it has the whole width
    return is_upright(w, h) ? scale_of(width, height) : std::min(w / 768.0F, h / 496.0F);
}

FrameLayout layout_of(int width, int height) {
    const Box frame{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    return layout_in(frame, FrameKind::picture, scale_of(width, height));
}

FrameLayout layout_without_panels(const Box& frame, float scale) {
    FrameLayout layout;
    layout.scene = rect_of(frame);
    layout.scene_safe = safe_part(frame, scale);
    return layout;
}

FrameLayout layout_in(const Box& frame, FrameKind kind, float scale, float density) {
    const float usual = scale_of(static_cast<int>(frame.width), static_cast<int>(frame.height));
    if (!is_upright(frame.width, frame.height)) {
        FrameLayout layout = column_at_right(frame, kind, scale, scale / usual);
        layout.for_fingers = is_turned_phone(usual, density);
        return layout;
    }
    return upright(
        frame, kind, scale, std::round(kFinger * (density > 0.0F ? density : kUnknownDensity * usual)));
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
