#include "render/surface/mesa_settings.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include <sys/mman.h>

namespace jw::render {

namespace {

constexpr const char* kWidth = "LP_NATIVE_VECTOR_WIDTH";

/// The width as Mesa reads it: decimal, octal or hexadecimal; nothing if Mesa uses the width of the
/// processor.
std::optional<long> wanted_width() {
    const char* const text = std::getenv(kWidth);
    if (text == nullptr) { return {}; }
    char* end = nullptr;
    const long width = std::strtol(text, &end, 0);
    if (end == text) { return {}; }
    return width;
}

// measured with Mesa 22.3.6 under ulimit -v: 1280 x 720 takes 640 MB on two cores, and 3840 x 2160 takes 1100
// MB. This is for libraries and their compiler, an arena and a stack for each thread, and colours and depths
// of four samples
constexpr std::size_t kMegabyte = std::size_t{1} << 20U;
constexpr std::size_t kLibraries = 500 * kMegabyte;
constexpr std::size_t kThread = 72 * kMegabyte;
constexpr unsigned kMostThreads = 16;
constexpr std::size_t kPixel = 64;
// the renderer refuses larger pictures
constexpr int kLargestSide = 16384;

}  // namespace

void settle_mesa() {
    const std::optional<long> width = wanted_width();
    if (!width) { return; }
    if (*width != 128 && *width != 256) {
        throw std::runtime_error(
            std::string("Mesa cannot draw with ") + kWidth + '=' + std::getenv(kWidth) +
            "; set it to 128 or 256, or unset it");
    }
    constexpr const char* kNoCache = "MESA_SHADER_CACHE_DISABLE";
    const char* const before = std::getenv(kNoCache);
    // set only once, because other threads may read the environment by now
    if (before == nullptr || std::string_view(before) != "true") { ::setenv(kNoCache, "true", 1); }
}

void check_address_space(int width, int height) {
    const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads);
    const auto side = [](int length) {
        return static_cast<std::size_t>(std::clamp(length, 0, kLargestSide));
    };
    const std::size_t pixels = side(width) * side(height);
    const std::size_t room = kLibraries + kThread * threads + kPixel * pixels;
    // only reserved, never used
    void* const reserved =
        ::mmap(nullptr, room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (reserved == MAP_FAILED) {
        throw std::runtime_error(
            "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels needs " +
            std::to_string(room / kMegabyte) +
            " MB of address space, more than is left; raise the limit (ulimit -v)");
    }
    ::munmap(reserved, room);
}

}  // namespace jw::render
