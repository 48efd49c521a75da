#include "render/png.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include <libdeflate.h>

#include "render/png_chunks.hpp"

namespace jw::render {
namespace {

// Level 1 of libdeflate without filters: these pictures are flat. Level 4 takes two thirds longer for 11 %
// less; the filter that subtracts the row above makes files a quarter larger.
constexpr int kDeflateLevel = 1;
constexpr std::uint8_t kNoFilter = 0;

struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

/// Room for one picture after the other: as large as the largest.
struct Room {
    std::unique_ptr<libdeflate_compressor, Free> compressor{libdeflate_alloc_compressor(kDeflateLevel)};
    std::vector<std::uint8_t> rows;  ///< of the picture, each behind the number of its filter
    std::vector<std::uint8_t> packed;
};

void copy_row(const Image& image, std::size_t row, std::uint8_t* to) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::uint8_t* const rgb = &image.rgb[3 * row * width];
    if (image.alpha.empty()) {
        std::copy_n(rgb, 3 * width, to);
        return;
    }
    const std::uint8_t* const alpha = &image.alpha[row * width];
    for (std::size_t n = 0; n < width; ++n) {
        std::copy_n(&rgb[3 * n], 3, &to[4 * n]);
        to[4 * n + 3] = alpha[n];
    }
}

std::span<const std::uint8_t> packed_rows(const Image& image, Room& room) {
    const std::size_t length = 1 + (image.alpha.empty() ? 3 : 4) * static_cast<std::size_t>(image.width);
    room.rows.resize(length * static_cast<std::size_t>(image.height));
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        room.rows[row * length] = kNoFilter;
        copy_row(image, row, &room.rows[row * length + 1]);
    }
    if (!room.compressor) { throw std::bad_alloc(); }
    room.packed.resize(libdeflate_zlib_compress_bound(room.compressor.get(), room.rows.size()));
    const std::size_t size = libdeflate_zlib_compress(
        room.compressor.get(), room.rows.data(), room.rows.size(), room.packed.data(), room.packed.size());
    return std::span(room.packed).first(size);
}

std::vector<std::uint8_t> head_of(const Image& image) {
    std::vector<std::uint8_t> head;
    append_png_number(head, static_cast<std::uint32_t>(image.width));
    append_png_number(head, static_cast<std::uint32_t>(image.height));
    // 8 bits a channel, RGB or RGBA, the one compression, the one set of filters, not interlaced
    for (const int value : {8, image.alpha.empty() ? 2 : 6, 0, 0, 0}) {
        head.push_back(static_cast<std::uint8_t>(value));
    }
    return head;
}

void check(const Image& image) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const bool is_opaque = image.alpha.empty();
    if (image.width > 0 && image.height > 0 && image.rgb.size() == 3 * pixels &&
        (is_opaque || image.alpha.size() == pixels)) {
        return;
    }
    throw std::invalid_argument(
        "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
        " pixels cannot have " + std::to_string(image.rgb.size()) + " bytes of colour" +
        (is_opaque ? "" : " and " + std::to_string(image.alpha.size()) + " of opacity"));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    check(image);
    // kept: pictures of a film are of one size, and memory from the system costs as much as copying
    thread_local Room room;
    const std::span<const std::uint8_t> packed = packed_rows(image, room);
    const std::span<const std::uint8_t> signature = png_signature();
    std::vector<std::uint8_t> file(signature.begin(), signature.end());
    append_png_chunk(file, "IHDR", head_of(image));
    append_png_chunk(file, "IDAT", packed);
    append_png_chunk(file, "IEND", {});
    return file;
}

std::string libdeflate_version() { return LIBDEFLATE_VERSION_STRING; }

}  // namespace jw::render
