#pragma once

#include <cstdint>
#include <vector>

#include "render/files/image.hpp"

namespace jw::render {

/// PNG of an opaque picture as stb_image_write makes it: the reference for measurements of `encode_png`.
std::vector<std::uint8_t> encode_png_plainly(const Image& image);

}  // namespace jw::render
