#pragma once

#include "render/camera.hpp"
#include "render/frame_size.hpp"

namespace jw::render {

/// Pixels of the device, counted from the bottom as GL does.
struct DeviceRect {
    int x, y;
    int width, height;

    bool empty() const { return width < 1 || height < 1; }
};

DeviceRect device_rect(const Rect& rect, const FrameSize& frame);

/// Empty where the two do not meet.
DeviceRect common_part(const DeviceRect& a, const DeviceRect& b);

}  // namespace jw::render
