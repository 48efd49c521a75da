#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image.hpp"

/// Pictures as PNG files, byte-deterministic.
namespace jw::render {

/// Encodes a picture as PNG, with an alpha channel where it has one. The same picture gives the same bytes on
/// every machine with the same libdeflate.
/// @throws std::invalid_argument if the picture is empty or its size and its data disagree.
std::vector<std::uint8_t> encode_png(const Image& image);

/// "1.14": bytes of pictures depend on it.
std::string libdeflate_version();

}  // namespace jw::render
