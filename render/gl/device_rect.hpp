#pragma once

#include "render/scene/camera.hpp"
#include "render/scene/frame_size.hpp"

namespace jw::render {

/// Rectangle in pixels of the device, counted from the bottom as in GL.
struct DeviceRect {
    int x, y;
    int width, height;

    bool empty() const { return width < 1 || height < 1; }
    bool operator==(const DeviceRect&) const = default;
};

DeviceRect device_rect(const Rect& rect, const FrameSize& frame);

/// A rectangle of the frame in the coordinates of a part's buffers; it may extend beyond them.
DeviceRect device_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// All pixels of the buffers of a part.
DeviceRect device_rect(const FramePart& part, const FrameSize& frame);

/// The part of a rectangle of the frame that lies in the buffers of a part.
DeviceRect shown_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// Intersection; empty if the two do not overlap.
DeviceRect common_part(const DeviceRect& a, const DeviceRect& b);

}  // namespace jw::render
