#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <string_view>

#include "render/files/png.hpp"
#include "render/files/png_reader.hpp"

namespace jw::render::test {

TEST_CASE("a picture is read as it was written", "[png]") {
    std::mt19937 random(5);
    for (const auto& [width, height] : {std::pair(1, 1), {3, 7}, {64, 5}}) {
        Image image{width, height, {}};
        image.rgb.resize(3 * static_cast<std::size_t>(width * height));
        for (std::uint8_t& byte : image.rgb) { byte = static_cast<std::uint8_t>(random() % 256); }
        CHECK(decode_png(encode_png(image), "a.png") == image);
    }
}

TEST_CASE("what is no picture is refused by name", "[png]") {
    const std::vector<std::uint8_t> whole = encode_png({8, 8, std::vector<std::uint8_t>(3 * 64, 7)});
    for (std::size_t length = 0; length + 16 < whole.size(); ++length) {
        CHECK_THROWS_WITH(
            decode_png(std::span(whole).first(length), "a.png"),
            Catch::Matchers::StartsWith("'a.png' cannot be read as a PNG picture: "));
    }
    // a header that asks for more memory than there is
    std::vector<std::uint8_t> huge = whole;
    for (std::size_t k = 16; k < 24; ++k) { huge[k] = 0x7F; }
    CHECK_THROWS_AS(decode_png(huge, "a.png"), std::runtime_error);
    constexpr unsigned seed = 11;
    std::mt19937 random(seed);
    for (int k = 0; k < 3000; ++k) {
        std::vector<std::uint8_t> changed = whole;
        changed[random() % changed.size()] = static_cast<std::uint8_t>(random() % 256);
        try {
            static_cast<void>(decode_png(changed, "a.png"));
        } catch (const std::runtime_error&) {}
    }
}

TEST_CASE("a few bytes of a PNG do not ask for memory that its picture has no use for", "[png]") {
    const std::vector<std::uint8_t> whole = encode_png({8, 8, std::vector<std::uint8_t>(3 * 64, 7)});
    const std::string_view data = "IDAT";
    const auto name = std::ranges::search(whole, data).begin();
    REQUIRE(name != whole.end());
    // a part that claims 1.2 GB, more than the file has
    std::vector<std::uint8_t> long_part = whole;
    long_part[static_cast<std::size_t>(name - whole.begin()) - 4] = 0x4D;
    CHECK_THROWS_WITH(decode_png(long_part, "a.png"), Catch::Contains("longer than the file"));
    // pixels of 64 rows, with a header that says 8
    std::vector<std::uint8_t> more = encode_png({8, 64, std::vector<std::uint8_t>(3 * 8 * 64, 7)});
    more[23] = 8;
    CHECK_THROWS_WITH(decode_png(more, "a.png"), Catch::Contains("more than its head says"));
}

}  // namespace jw::render::test
