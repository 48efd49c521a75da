#include <span>

#include "render/files/png.hpp"
#include "render/files/png_reader.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

// golden pictures are read at the size that their record says; a few bytes can claim 16384 x 16384
constexpr int kMostPixels = 512 * 512;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

bool check_picture(const std::string& input) {
    try {
        const auto [width, height] = render::size_of_png(bytes_of(input), "input.png");
        promise(
            width > 0 && height > 0 && width <= render::kLargestPicture && height <= render::kLargestPicture,
            "a size in its range");
        if (width > kMostPixels / height) { return false; }
        const render::Image image = render::decode_png(bytes_of(input), "input.png");
        promise(image.width == width && image.height == height, "the size of the head");
        promise(
            render::decode_png(render::encode_png(image), "written.png") == image,
            "a picture that is written again is the same");
        return true;
    } catch (const std::runtime_error& refused) {
        promise(
            std::string(refused.what()).find("input.png") != std::string::npos, "a refusal names the file");
    }
    return false;
}

}  // namespace jw::fuzz
