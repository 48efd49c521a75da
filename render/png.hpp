#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/image.hpp"

/// Pictures as PNG files, byte-deterministic.
namespace jw::render {

/// Encodes a picture as PNG, with an alpha channel where it has one. The same picture gives the same bytes on
/// every machine with the same libdeflate.
/// @throws std::invalid_argument if the picture is empty or its size and its data disagree.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Number in the first four bytes, as PNG writes it. There must be four.
std::uint32_t png_number(std::span<const std::uint8_t> bytes);
/// Checksum of a chunk of a PNG file, over its type and its data.
std::uint32_t png_checksum(std::span<const std::uint8_t> bytes);

/// True for a PNG file of which nothing is missing and nothing has changed, by the checksums in it.
bool is_whole_png(std::span<const std::uint8_t> bytes);

/// "1.14": bytes of pictures depend on it.
std::string libdeflate_version();

}  // namespace jw::render
