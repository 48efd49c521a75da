#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "render/files/image.hpp"

namespace jw::render {

/// Largest width or height that is read.
inline constexpr int kLargestPicture = 16384;

/// Width and height of a PNG, without decoding it.
/// @throws std::runtime_error as `decode_png` does
std::array<int, 2> size_of_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// What happens to the alpha channel of a picture that is read.
enum class Alpha : bool { lost, kept };

/// Decodes a PNG of any kind as 8-bit RGB.
/// @param name  of the file, for the error
/// @param alpha  kept: reads the alpha channel if the file has one
/// @throws std::runtime_error if it is not a PNG, or is cut off, damaged or too large
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name, Alpha alpha = Alpha::lost);

}  // namespace jw::render
