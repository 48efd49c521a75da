#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "render/image.hpp"

namespace jw::render {

/// Largest width or height that is read.
inline constexpr int kLargestPicture = 16384;

/// Decodes a PNG of any kind as 8-bit RGB; what is transparent loses that.
/// @param name  of the file, for the error
/// @throws std::runtime_error if it is no PNG, cut off, damaged or too large
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace jw::render
