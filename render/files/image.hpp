#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jw::render {

/// RGB picture, 8 bits per channel, top row first, no padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    std::vector<std::uint8_t> alpha =
        {};  ///< one per pixel, 255 where it is opaque; empty: all pixels are opaque

    bool operator==(const Image&) const = default;

    /// Number of a pixel in its order; x and y must lie inside.
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    /// The three channels of a pixel.
    const std::uint8_t* at(int x, int y) const { return &rgb[3 * place(x, y)]; }
};

}  // namespace jw::render
