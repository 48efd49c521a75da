#pragma once

#include <cstdint>
#include <vector>

#include "render/image.hpp"

namespace jw::render {

/// PNG of an opaque picture as stb_image_write makes it by itself: what `encode_png` is measured against.
std::vector<std::uint8_t> encode_png_plainly(const Image& image);

}  // namespace jw::render
