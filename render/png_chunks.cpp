#include "render/png_chunks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include <libdeflate.h>

namespace jw::render {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kHeadLength = 13;
// length, name and check sum around what a chunk holds
constexpr std::size_t kAroundPart = 12;

std::size_t number_at(Bytes bytes, std::size_t at) {
    std::size_t number = 0;
    for (std::size_t k = 0; k < 4; ++k) { number = number << 8U | bytes[at + k]; }
    return number;
}

bool is_called(Bytes bytes, std::size_t at, std::string_view name) {
    return std::ranges::equal(
        bytes.subspan(at, 4), name, [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
}

/// Bytes that the pixels of a head may unpack to: rows with a filter each, and as many once more for the
/// seven passes of an interlaced picture, whose rows are short.
std::size_t largest_unpacked(Bytes head) {
    const std::size_t width = number_at(head, 0);
    const std::size_t height = number_at(head, 4);
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

std::string fault_of_png(Bytes bytes) {
    if (bytes.size() < kSignature.size() || !std::ranges::equal(bytes.first(kSignature.size()), kSignature)) {
        return "it does not begin as one";
    }
    Bytes head;
    std::vector<std::uint8_t> packed;
    for (std::size_t at = kSignature.size(); at + kAroundPart <= bytes.size();) {
        const std::size_t length = number_at(bytes, at);
        if (length > bytes.size() - at - kAroundPart) { return "a part of it is longer than the file"; }
        const Bytes held = bytes.subspan(at + 8, length);
        if (head.empty() != is_called(bytes, at + 4, "IHDR")) {
            return "its head is not at the beginning, or there twice";
        }
        if (head.empty()) { head = held; }
        if (head.size() != kHeadLength) { return "its head is too short or too long"; }
        const bool pixels = is_called(bytes, at + 4, "IDAT");
        // allowed, written by nobody, and the decoder copies it to a place that it has not reserved
        if (pixels && held.empty()) { return "a part of its pixels is empty"; }
        if (pixels) { packed.insert(packed.end(), held.begin(), held.end()); }
        if (is_called(bytes, at + 4, "IEND")) {
            return fits(packed, largest_unpacked(head))
                       ? ""
                       : "its pixels are damaged, or more than its head says";
        }
        at += length + kAroundPart;
    }
    return "it is cut off";
}

}  // namespace jw::render
