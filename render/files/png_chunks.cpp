#include "render/files/png_chunks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include <libdeflate.h>

namespace jw::render {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kHeadLength = 13;
// length, name and checksum around the data of a chunk
constexpr std::size_t kAroundPart = 12;

/// Largest number of bytes that the pixels may unpack to according to the head: rows with a filter each, and
/// the same again for the seven passes of an interlaced picture, whose rows are short.
std::size_t largest_unpacked(Bytes head) {
    const std::size_t width = png_number(head);
    const std::size_t height = png_number(head.subspan(4));
    constexpr std::size_t kSide = 1U << 16U;
    if (width > kSide || height > kSide) { return 0; }
    constexpr std::array<std::size_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};
    const std::size_t channels = head[9] < kChannels.size() ? kChannels[head[9]] : 0;
    const std::size_t row = (width * channels * std::min<std::size_t>(head[8], 16) + 7) / 8 + 1;
    const bool interlaced = head[12] != 0;
    return row * height + (interlaced ? row * height + 8 * (height + row) : 0);
}

bool fits(Bytes packed, std::size_t most) {
    struct FreeDecompressor {
        void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
    };
    const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
        libdeflate_alloc_decompressor());
    if (!decompressor) { return false; }
    std::vector<std::uint8_t> unpacked(most);
    std::size_t length = 0;
    return libdeflate_zlib_decompress(
               decompressor.get(), packed.data(), packed.size(), unpacked.data(), most, &length) ==
           LIBDEFLATE_SUCCESS;
}

}  // namespace

PngChunks::PngChunks(Bytes bytes) {
    is_png_ =
        bytes.size() >= kSignature.size() && std::ranges::equal(bytes.first(kSignature.size()), kSignature);
    if (is_png_) { rest_ = bytes.subspan(kSignature.size()); }
}

bool PngChunks::is_too_long() const {
    return rest_.size() >= kAroundPart && png_number(rest_) > rest_.size() - kAroundPart;
}

std::optional<PngChunk> PngChunks::next() {
    if (rest_.size() < kAroundPart || is_too_long()) { return std::nullopt; }
    const std::size_t length = png_number(rest_);
    PngChunk chunk{
        {reinterpret_cast<const char*>(rest_.data()) + 4, 4},
        rest_.subspan(8, length),
        rest_.subspan(4, 4 + length),
        png_number(rest_.subspan(8 + length))};
    rest_ = rest_.subspan(kAroundPart + length);
    return chunk;
}

Bytes png_signature() { return kSignature; }

std::uint32_t png_number(Bytes bytes) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.first(4)) { value = value << 8U | byte; }
    return value;
}

std::uint32_t png_checksum(Bytes checked) { return libdeflate_crc32(0, checked.data(), checked.size()); }

void append_png_number(std::vector<std::uint8_t>& file, std::uint32_t value, int count) {
    for (int k = count - 1; k >= 0; --k) { file.push_back(static_cast<std::uint8_t>(value >> (8 * k))); }
}

void append_png_chunk(std::vector<std::uint8_t>& file, std::string_view type, Bytes data) {
    append_png_number(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    append_png_number(file, png_checksum(std::span(file).subspan(begin)));
}

bool is_whole_png(Bytes bytes) {
    PngChunks chunks(bytes);
    while (const std::optional<PngChunk> chunk = chunks.next()) {
        if (png_checksum(chunk->checked) != chunk->checksum) { return false; }
        if (chunk->type == "IEND") { return chunks.rest().empty(); }
    }
    return false;
}

std::string fault_of_png(Bytes bytes) {
    PngChunks chunks(bytes);
    if (!chunks.is_png()) { return "it does not begin as one"; }
    Bytes head;
    std::vector<std::uint8_t> packed;
    while (const std::optional<PngChunk> chunk = chunks.next()) {
        if (head.empty() != (chunk->type == "IHDR")) {
            return "its head is not at the beginning, or there twice";
        }
        if (head.empty()) { head = chunk->data; }
        if (head.size() != kHeadLength) { return "its head is too short or too long"; }
        const bool pixels = chunk->type == "IDAT";
        // allowed, but never written in practice; the decoder would copy it to memory that it has not
        // reserved
        if (pixels && chunk->data.empty()) { return "a part of its pixels is empty"; }
        if (pixels) { packed.insert(packed.end(), chunk->data.begin(), chunk->data.end()); }
        if (chunk->type == "IEND") {
            return fits(packed, largest_unpacked(head))
                       ? ""
                       : "its pixels are damaged, or more than its head says";
        }
    }
    return chunks.is_too_long() ? "a part of it is longer than the file" : "it is cut off";
}

}  // namespace jw::render
