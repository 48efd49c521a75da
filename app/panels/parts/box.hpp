#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "render/scene/camera.hpp"

/// Rectangles of panels in pixels of the frame: origin at the top left corner, y down.
namespace jw::panels {

struct Point {
    float x = 0.0F;
    float y = 0.0F;
};

struct Box {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;

    float right() const { return x + width; }
    float bottom() const { return y + height; }
    Point centre() const { return {x + 0.5F * width, y + 0.5F * height}; }
    bool contains(Point p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
    bool contains(const Box& b) const {
        return b.x >= x && b.right() <= right() && b.y >= y && b.bottom() <= bottom();
    }
};

inline bool overlap(const Box& a, const Box& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// The common part of two boxes; width or height 0 if there is none.
inline Box common(const Box& a, const Box& b) {
    const float left = std::max(a.x, b.x);
    const float top = std::max(a.y, b.y);
    return {
        left, top, std::max(0.0F, std::min(a.right(), b.right()) - left),
        std::max(0.0F, std::min(a.bottom(), b.bottom()) - top)};
}

inline Box shrunk(const Box& box, float dx, float dy) {
    return {
        box.x + dx, box.y + dy, std::max(0.0F, box.width - 2.0F * dx),
        std::max(0.0F, box.height - 2.0F * dy)};
}

/// A box without height below the first `used` pixels of another one.
inline Box below(const Box& box, float used) { return {box.x, box.y + used, box.width, 0.0F}; }

/// Column `index` of `count` equal ones.
inline Box column_of(const Box& box, int index, int count) {
    const float width = box.width / static_cast<float>(count);
    return {box.x + width * static_cast<float>(index), box.y, width, box.height};
}

/// Cuts a strip off the top of `rest`.
inline Box cut_top(Box& rest, float height) {
    const float taken = std::min(height, rest.height);
    const Box top{rest.x, rest.y, rest.width, taken};
    rest.y += taken;
    rest.height -= taken;
    return top;
}

inline Box cut_left(Box& rest, float width) {
    const float taken = std::min(width, rest.width);
    const Box left{rest.x, rest.y, taken, rest.height};
    rest.x += taken;
    rest.width -= taken;
    return left;
}

/// The part of a line within a box, by Liang and Barsky; empty if there is none.
inline std::optional<std::array<Point, 2>> clipped(Point a, Point b, const Box& box) {
    float enter = 0.0F;
    float leave = 1.0F;
    const float dx = b.x - a.x;
    const float dy = b.y - a.y;
    const std::array<std::array<float, 2>, 4> sides{
        {{-dx, a.x - box.x}, {dx, box.right() - a.x}, {-dy, a.y - box.y}, {dy, box.bottom() - a.y}}};
    for (const auto& [slope, room] : sides) {
        if (slope == 0.0F) {
            if (room < 0.0F) { return std::nullopt; }
        } else if (slope < 0.0F) {
            enter = std::max(enter, room / slope);
        } else {
            leave = std::min(leave, room / slope);
        }
    }
    if (enter > leave) { return std::nullopt; }
    return std::array<Point, 2>{{{a.x + enter * dx, a.y + enter * dy}, {a.x + leave * dx, a.y + leave * dy}}};
}

inline render::Rect rect_of(const Box& box) { return {box.x, box.y, box.width, box.height}; }

inline Box box_of(const render::Rect& rect) {
    return {
        static_cast<float>(rect.x), static_cast<float>(rect.y), static_cast<float>(rect.width),
        static_cast<float>(rect.height)};
}

}  // namespace jw::panels
