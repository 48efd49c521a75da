#pragma once

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <stb_image.h>

#include "render/image.hpp"

namespace jw::test {

/// @throws std::runtime_error naming `path` and the reason.
inline render::Image read_png(const std::filesystem::path& path) {
    render::Image image;
    int channels = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> pixels(
        stbi_load(path.c_str(), &image.width, &image.height, &channels, 3), &std::free);
    if (!pixels) {
        throw std::runtime_error("cannot read '" + path.string() + "': " + stbi_failure_reason());
    }
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgb.assign(pixels.get(), pixels.get() + 3 * count);
    return image;
}

}  // namespace jw::test
