#include "render/files/png_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>

#include "render/files/png_chunks.hpp"

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

struct Info {
    int width = 0;
    int height = 0;
    int channels = 0;
};

Info info_of(std::span<const std::uint8_t> bytes, const std::string& name) {
    Info info;
    const int length = length_of(bytes, name);
    if (stbi_info_from_memory(bytes.data(), length, &info.width, &info.height, &info.channels) == 0) {
        fail(name, stbi_failure_reason());
    }
    return info;
}

using Pixels = std::unique_ptr<unsigned char, Free>;

Image opaque(const Pixels& rgb, int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, {rgb.get(), rgb.get() + 3 * count}};
}

Image transparent(const Pixels& rgba, int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Image image{width, height, std::vector<std::uint8_t>(3 * count), std::vector<std::uint8_t>(count)};
    for (std::size_t n = 0; n < count; ++n) {
        std::copy_n(rgba.get() + 4 * n, 3, &image.rgb[3 * n]);
        image.alpha[n] = rgba.get()[4 * n + 3];
    }
    return image;
}

}  // namespace

std::array<int, 2> size_of_png(std::span<const std::uint8_t> bytes, const std::string& name) {
    const Info info = info_of(bytes, name);
    return {info.width, info.height};
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name, Alpha alpha) {
    if (const std::string fault = fault_of_png(bytes); !fault.empty()) { fail(name, fault); }
    auto [width, height, channels] = info_of(bytes, name);
    const bool keeps_alpha = alpha == Alpha::kept && (channels == 2 || channels == 4);
    const Pixels pixels(stbi_load_from_memory(
        bytes.data(), length_of(bytes, name), &width, &height, &channels,
        keeps_alpha ? STBI_rgb_alpha : STBI_rgb));
    if (!pixels) { fail(name, stbi_failure_reason()); }
    return keeps_alpha ? transparent(pixels, width, height) : opaque(pixels, width, height);
}

}  // namespace jw::render
