#include "render/png_reader.hpp"

#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb_image.h>

namespace jw::render {

static_assert(STBI_MAX_DIMENSIONS == kLargestPicture);

namespace {

struct Free {
    void operator()(unsigned char* memory) const { stbi_image_free(memory); }
};

[[noreturn]] void fail(const std::string& name, const std::string& why) {
    throw std::runtime_error("'" + name + "' cannot be read as a PNG picture: " + why);
}

int length_of(std::span<const std::uint8_t> bytes, const std::string& name) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        fail(name, "it is too large");
    }
    return static_cast<int>(bytes.size());
}

}  // namespace

std::array<int, 2> size_of_png(std::span<const std::uint8_t> bytes, const std::string& name) {
    std::array<int, 2> size{};
    int channels = 0;
    if (stbi_info_from_memory(bytes.data(), length_of(bytes, name), &size[0], &size[1], &channels) == 0) {
        fail(name, stbi_failure_reason());
    }
    return size;
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
    Image image;
    int channels = 0;
    const std::unique_ptr<unsigned char, Free> pixels(stbi_load_from_memory(
        bytes.data(), length_of(bytes, name), &image.width, &image.height, &channels, 3));
    if (!pixels) { fail(name, stbi_failure_reason()); }
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgb.assign(pixels.get(), pixels.get() + 3 * count);
    return image;
}

}  // namespace jw::render
