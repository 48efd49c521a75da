#include "render/png.hpp"

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include <libdeflate.h>

namespace {

// Level 6 of libdeflate with no PNG filter: 10-20 times faster than the zlib inside stb_image_write and
// smaller, because these pictures are flat.
constexpr int kDeflateLevel = 6;

/// The hook of stb_image_write: owns nothing, returns memory for its STBIW_FREE.
unsigned char* compress_for_stb(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
    struct Free {
        void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
    };
    const std::unique_ptr<libdeflate_compressor, Free> compressor(libdeflate_alloc_compressor(kDeflateLevel));
    if (!compressor) { return nullptr; }
    const auto bytes = static_cast<std::size_t>(size);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), bytes);
    auto* const compressed = static_cast<unsigned char*>(std::malloc(bound));
    if (compressed == nullptr) { return nullptr; }
    *compressed_size =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, bytes, compressed, bound));
    return compressed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_for_stb
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace jw::render {
namespace {

struct Free {
    void operator()(unsigned char* memory) const { std::free(memory); }
};
using Memory = std::unique_ptr<unsigned char, Free>;

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width <= 0 || image.height <= 0 || image.rgb.size() != 3 * pixels) {
        throw std::invalid_argument(
            "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
            " pixels cannot have " + std::to_string(image.rgb.size()) + " bytes of colour");
    }
    // once: pictures may be encoded on several threads
    static const int no_filter = stbi_write_force_png_filter = 0;
    static_cast<void>(no_filter);
    int size = 0;
    const Memory png(
        stbi_write_png_to_mem(image.rgb.data(), 3 * image.width, image.width, image.height, 3, &size));
    if (!png) { throw std::bad_alloc(); }
    return {png.get(), png.get() + size};
}

std::string libdeflate_version() { return LIBDEFLATE_VERSION_STRING; }

}  // namespace jw::render
