#pragma once

#include "render/camera.hpp"
#include "render/frame_size.hpp"

namespace jw::render {

/// Pixels of the device, counted from the bottom as GL does.
struct DeviceRect {
    int x, y;
    int width, height;

    bool empty() const { return width < 1 || height < 1; }
    bool operator==(const DeviceRect&) const = default;
};

DeviceRect device_rect(const Rect& rect, const FrameSize& frame);

/// A rectangle of the frame in the buffers of a part of it, where it may begin before and end behind them.
DeviceRect device_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// All pixels of the buffers of a part.
DeviceRect device_rect(const FramePart& part, const FrameSize& frame);

/// A rectangle of the frame as far as it is in the buffers of a part.
DeviceRect shown_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// Empty where the two do not meet.
DeviceRect common_part(const DeviceRect& a, const DeviceRect& b);

}  // namespace jw::render
