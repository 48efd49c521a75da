#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "render/image.hpp"

namespace jw::render {

/// Largest width or height that is read.
inline constexpr int kLargestPicture = 16384;

/// Width and height of a PNG, without decoding it.
/// @throws std::runtime_error as `decode_png` does
std::array<int, 2> size_of_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Decodes a PNG of any kind as 8-bit RGB; what is transparent loses that.
/// @param name  of the file, for the error
/// @throws std::runtime_error if it is no PNG, cut off, damaged or too large
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace jw::render
