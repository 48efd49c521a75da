#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/image.hpp"

/// Pictures as PNG files: byte-deterministic, and whole or not there at all.
namespace jw::render {

/// The same picture gives the same bytes on every machine with the same libdeflate.
/// @throws std::invalid_argument if the picture is empty or its size and its data disagree.
std::vector<std::uint8_t> encode_png(const Image& image);

/// @throws std::runtime_error naming `path` and the reason.
Image read_png(const std::filesystem::path& path);

/// Writes beside `path` under a temporary name, then renames: a reader never sees half a file, and a failure
/// leaves what was there before.
/// @throws std::runtime_error naming `path` and the reason (disk full, no such folder, permission).
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// "1.14": bytes of pictures depend on it.
std::string libdeflate_version();

}  // namespace jw::render
