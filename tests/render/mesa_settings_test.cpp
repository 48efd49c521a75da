#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

#include "render/surface/mesa_settings.hpp"

namespace jw::render::test {
namespace {

constexpr const char* kRegisters = "LP_NATIVE_VECTOR_WIDTH";
constexpr const char* kCache = "MESA_SHADER_CACHE_DISABLE";

/// Switch of Mesa's cache as `settle_mesa` sets it; empty if it is not set.
std::string cache_with_width(const char* width) {
    ::unsetenv(kCache);
    ::setenv(kRegisters, width, 1);
    settle_mesa();
    const char* const cache = std::getenv(kCache);
    ::unsetenv(kRegisters);
    return cache == nullptr ? "" : cache;
}

}  // namespace

TEST_CASE("Mesa's cache is off exactly where a width of registers is chosen", "[render][mesa]") {
    for (const char* width : {"128", "0x80", "0200", "256"}) { CHECK(cache_with_width(width) == "true"); }
    // Mesa takes these for nothing
    for (const char* width : {"", "wide"}) { CHECK(cache_with_width(width).empty()); }
    ::unsetenv(kCache);
    settle_mesa();
    CHECK(std::getenv(kCache) == nullptr);
}

TEST_CASE("a width of registers at which Mesa ends the program is refused and named", "[render][mesa]") {
    for (const char* width : {"0", "64", "512", "-1", "0x200"}) {
        ::setenv(kRegisters, width, 1);
        CHECK_THROWS_WITH(
            settle_mesa(), "Mesa cannot draw with LP_NATIVE_VECTOR_WIDTH=" + std::string(width) +
                               "; set it to 128 or 256, or unset it");
    }
    ::unsetenv(kRegisters);
}

}  // namespace jw::render::test
