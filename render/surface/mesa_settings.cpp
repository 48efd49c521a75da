#include "render/surface/mesa_settings.hpp"

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

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

}  // namespace jw::render
