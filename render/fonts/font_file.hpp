#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Font files as bytes, and a check that they are complete: libraries that read fonts trust them.
namespace jw::render {

/// @throws std::runtime_error naming `path` and why it cannot be read, or what is wrong with it
std::vector<std::uint8_t> read_font_file(const std::filesystem::path& path);

/// Fault of a TrueType or OpenType file of one font, such as "it ends too early"; empty if there is none.
/// Every table must lie within the file and have the checksum that the file gives, and all tables that text
/// needs must be there.
/// @source OpenType specification 1.9, "Font file", table directory
std::string fault_of_font(std::span<const std::uint8_t> bytes);

}  // namespace jw::render
