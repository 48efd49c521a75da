#pragma once

#include <cstdint>
#include <vector>

namespace jw::render {

/// Id and depth of the part that is seen at each pixel of a picture: the same scene without light, text and
/// smooth edges. Top row first.
struct PictureLayers {
    /// Depth of a point that is as far away as the camera's target; the largest value is four times as far.
    static constexpr int kDepthOfTarget = 1 << 14;

    int width = 0;
    int height = 0;
    std::vector<int> ids;              ///< ids of the scene's parts; 0: nothing with an id
    std::vector<std::uint16_t> depth;  ///< 0: nothing

    bool operator==(const PictureLayers&) const = default;
};

}  // namespace jw::render
