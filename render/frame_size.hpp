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

}  // namespace jw::render
