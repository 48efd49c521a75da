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
    std::uint32_t checksum = 0;             ///< as the file has it
};

/// Chunks of a file in their order; its lengths are not trusted.
class PngChunks {
public:
    /// `bytes` must outlive this.
    explicit PngChunks(std::span<const std::uint8_t> bytes);

    /// True if the file begins as a PNG; else it has no chunks.
    bool is_png() const { return is_png_; }
    /// The next chunk; nothing where none is left, or what is left is shorter than it says.
    std::optional<PngChunk> next();
    /// Bytes behind the last chunk.
    std::span<const std::uint8_t> rest() const { return rest_; }
    /// True if `rest` begins with a chunk that is longer than the file.
    bool is_too_long() const;

private:
    bool is_png_ = false;
    std::span<const std::uint8_t> rest_;
};

/// The eight bytes that a PNG file begins with.
std::span<const std::uint8_t> png_signature();
/// Number in the first four bytes, as PNG writes it. There must be four.
std::uint32_t png_number(std::span<const std::uint8_t> bytes);
/// Checksum of a chunk, over its type and its data.
std::uint32_t png_checksum(std::span<const std::uint8_t> checked);
/// Appends the `count` lower bytes of a number, as PNG writes it.
void append_png_number(std::vector<std::uint8_t>& file, std::uint32_t value, int count = 4);
/// Appends a chunk with its length and checksum.
void append_png_chunk(
    std::vector<std::uint8_t>& file, std::string_view type, std::span<const std::uint8_t> data);

/// True for a PNG file of which nothing is missing and nothing has changed, by the checksums in it.
bool is_whole_png(std::span<const std::uint8_t> bytes);

/// Looks at a PNG before a decoder trusts its lengths: a few bytes can claim chunks and pixels that take more
/// memory than there is. Whether its pixels are right is left to the decoder.
/// @return what is wrong: no head, a chunk that is longer than the file, pixels that unpack to more than the
/// head says; empty
///         if nothing is
std::string fault_of_png(std::span<const std::uint8_t> bytes);

}  // namespace jw::render
