#include "render/files/plain_png.hpp"

#include <cstdlib>
#include <memory>
#include <new>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace jw::render {

std::vector<std::uint8_t> encode_png_plainly(const Image& image) {
    struct Free {
        void operator()(unsigned char* memory) const { std::free(memory); }
    };
    int size = 0;
    const std::unique_ptr<unsigned char, Free> png(
        stbi_write_png_to_mem(image.rgb.data(), 3 * image.width, image.width, image.height, 3, &size));
    if (!png) { throw std::bad_alloc(); }
    return {png.get(), png.get() + size};
}

}  // namespace jw::render
