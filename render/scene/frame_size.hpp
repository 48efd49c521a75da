#pragma once

namespace jw::render {

/// Size of the frame that is drawn into. `pixel_ratio` device pixels stand for one pixel of the picture:
/// usually 1, but 2 if a driver without multisampling requires drawing at double size.
struct FrameSize {
    int width = 0;  ///< pixels of the picture
    int height = 0;
    int pixel_ratio = 1;

    bool operator==(const FrameSize&) const = default;
};

/// Part of a frame that is drawn into buffers of its own size: usually all of it; one of several tiles if the
/// frame is larger than the buffers can be. Pixels of the picture, from its upper left corner.
struct FramePart {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const FramePart&) const = default;
};

}  // namespace jw::render
