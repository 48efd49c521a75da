#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace jw::render {

/// Writes a file that appears whole or not at all, in place of the one of that name if there is one. Where
/// the file system allows it, what is being written has no name until then, so that nothing is left behind
/// even if the program is killed.
///
/// A program that wants to be told of a file that grows beyond its limit (ulimit -f) must ignore SIGXFSZ.
/// @throws std::runtime_error naming `path` and the reason: no room, no right, or something under this name
/// that
///         is no file (a folder, a device, a pipe)
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// A file and all that is to be in it.
struct WholeFile {
    std::filesystem::path path;
    std::span<const std::uint8_t> bytes;
};

/// The bytes of a text, which must outlive them.
std::span<const std::uint8_t> bytes_of(std::string_view text);

/// Writes files that belong together, in this order: where one cannot be written, all stay as they were. Only
/// their renaming, which needs no room, is done one by one.
/// @throws std::runtime_error as `write_file_atomically`
void write_files_atomically(std::span<const WholeFile> files);

/// Checks that `write_file_atomically` can succeed, before the content is computed.
/// @throws std::runtime_error as that, where the name cannot be that of a file or its folder is not there
void check_can_be_written(const std::filesystem::path& path);

}  // namespace jw::render
