#pragma once

#include <cstdint>
#include <vector>

namespace jw::render {

/// Things seen at each pixel of a picture, and how far away they are: the same scene without light, text and
/// smooth edges. Top row first.
struct PictureLayers {
    /// Depth of what is as far away as the camera's target; the largest value is four times as far.
    static constexpr int kDepthOfTarget = 1 << 14;

    int width = 0;
    int height = 0;
    std::vector<int> ids;              ///< of the scene's parts; 0: nothing that has one
    std::vector<std::uint16_t> depth;  ///< 0: nothing

    bool operator==(const PictureLayers&) const = default;
};

}  // namespace jw::render
