#pragma once

namespace jw::render {

/// Size of the frame that is drawn into. `pixel_ratio` device pixels stand for one pixel of the picture:
/// 1 as a rule, 2 where a driver without multisampling makes us draw at double size.
struct FrameSize {
    int width = 0;  ///< pixels of the picture
    int height = 0;
    int pixel_ratio = 1;

    bool operator==(const FrameSize&) const = default;
};

/// Part of a frame that is drawn into buffers of its own size: all of it as a rule, one of several tiles
/// where it is larger than what buffers are made for. Pixels of the picture, from its upper left corner.
struct FramePart {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const FramePart&) const = default;
};

}  // namespace jw::render
