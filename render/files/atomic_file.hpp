#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace jw::render {

/// Writes a file that appears completely or not at all, and replaces an existing one. Where the file system
/// allows it, the file has no name until it is complete, so that nothing is left behind even if the program
/// is killed.
///
/// A program must ignore SIGXFSZ to get an error if a file grows beyond its limit (ulimit -f).
/// @throws std::runtime_error naming `path` and the reason: no space, no permission, or something under this
/// name that is not a file (a folder, a device, a pipe)
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// A file and its whole content.
struct WholeFile {
    std::filesystem::path path;
    std::span<const std::uint8_t> bytes;
};

/// The bytes of a text, which must outlive them.
std::span<const std::uint8_t> bytes_of(std::string_view text);

/// Writes files that belong together, in this order. If one cannot be written, all stay unchanged. Only their
/// renaming, which needs no space, is done one by one.
/// @throws std::runtime_error as `write_file_atomically`
void write_files_atomically(std::span<const WholeFile> files);

/// Checks that `write_file_atomically` can succeed, before the content is computed.
/// @throws std::runtime_error as `write_file_atomically`, if the name cannot be that of a file or its folder
/// does not exist
void check_can_be_written(const std::filesystem::path& path);

}  // namespace jw::render
