#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// PNG files as chunks: a type, data, and a checksum over both.
namespace jw::render {

struct PngChunk {
    std::string_view type;  ///< "IHDR"
    std::span<const std::uint8_t> data;
    std::span<const std::uint8_t> checked;  ///< type and data
    std::uint32_t checksum = 0;             ///< as stored in the file
};

/// Chunks of a file in their order; the lengths in the file are not trusted.
class PngChunks {
public:
    /// `bytes` must outlive this.
    explicit PngChunks(std::span<const std::uint8_t> bytes);

    /// True if the file begins like a PNG; otherwise it has no chunks.
    bool is_png() const { return is_png_; }
    /// The next chunk; nothing if none is left, or if the rest is shorter than the chunk says.
    std::optional<PngChunk> next();
    /// Bytes after the last chunk.
    std::span<const std::uint8_t> rest() const { return rest_; }
    /// True if `rest` begins with a chunk that is longer than the file.
    bool is_too_long() const;

private:
    bool is_png_ = false;
    std::span<const std::uint8_t> rest_;
};

/// The first eight bytes of a PNG file.
std::span<const std::uint8_t> png_signature();
/// Number in the first four bytes, big-endian as everywhere in PNG. There must be four bytes.
std::uint32_t png_number(std::span<const std::uint8_t> bytes);
/// Checksum of a chunk, over its type and its data.
std::uint32_t png_checksum(std::span<const std::uint8_t> checked);
/// Appends the `count` lower bytes of a number, big-endian.
void append_png_number(std::vector<std::uint8_t>& file, std::uint32_t value, int count = 4);
/// Appends a chunk with its length and checksum.
void append_png_chunk(
    std::vector<std::uint8_t>& file, std::string_view type, std::span<const std::uint8_t> data);

/// True if, by its checksums, the PNG file is complete and unchanged.
bool is_whole_png(std::span<const std::uint8_t> bytes);

/// Checks a PNG before a decoder trusts its lengths: a few bytes can claim chunks and pixels that take more
/// memory than there is. The decoder checks whether the pixels are right.
/// @return what is wrong: no head, a chunk that is longer than the file, or pixels that unpack to more than
/// the head says; empty if nothing is wrong
std::string fault_of_png(std::span<const std::uint8_t> bytes);

}  // namespace jw::render
