#include "render/gl/device_rect.hpp"

#include <algorithm>
#include <cmath>

namespace jw::render {

DeviceRect device_rect(const Rect& rect, const FrameSize& frame) {
    const auto pixels = [&](double length) {
        return static_cast<int>(std::lround(length * frame.pixel_ratio));
    };
    return {
        pixels(rect.x), pixels(frame.height - rect.y - rect.height), pixels(rect.width), pixels(rect.height)};
}

DeviceRect device_rect(const Rect& rect, const FrameSize& frame, const FramePart& part) {
    DeviceRect seen = device_rect(rect, frame);
    seen.x -= part.x * frame.pixel_ratio;
    seen.y -= (frame.height - part.y - part.height) * frame.pixel_ratio;
    return seen;
}

DeviceRect device_rect(const FramePart& part, const FrameSize& frame) {
    return {0, 0, part.width * frame.pixel_ratio, part.height * frame.pixel_ratio};
}

DeviceRect shown_rect(const Rect& rect, const FrameSize& frame, const FramePart& part) {
    return common_part(device_rect(rect, frame, part), device_rect(part, frame));
}

DeviceRect common_part(const DeviceRect& a, const DeviceRect& b) {
    const int left = std::max(a.x, b.x);
    const int bottom = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width);
    const int top = std::min(a.y + a.height, b.y + b.height);
    return {left, bottom, std::max(right - left, 0), std::max(top - bottom, 0)};
}

}  // namespace jw::render
