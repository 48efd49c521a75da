#include <catch2/catch.hpp>

#include <fstream>

#include "render/fonts/font_face.hpp"
#include "render/fonts/fonts.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::filesystem::path written(const TemporaryFolder& folder, const Bytes& bytes) {
    const auto path = folder.path() / "font.ttf";
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

}  // namespace

TEST_CASE("the fonts of Debian's packages are whole", "[render][fonts]") {
    for (const FontSource& source : find_fonts()) {
        CAPTURE(source.path);
        CHECK(source.state == FontSource::State::right);
        CHECK(fault_of_font(read_font_file(source.path)) == "");
    }
}

TEST_CASE(
    "a font that is cut off is never taken for whole, one with another byte never ends the program",
    "[render][fonts]") {
    const TemporaryFolder folder;
    constexpr std::uint32_t seed = 15;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const FontSource& source : find_fonts()) {
        const Bytes whole = read_font_file(source.path);
        for (int sample = 0; sample < 30; ++sample) {
            Bytes bytes = whole;
            const std::size_t at = sample == 0 ? 0 : random() % whole.size();
            bytes.resize(at);
            CAPTURE(source.name, at);
            CHECK(fault_of_font(bytes) != "");
            CHECK_THROWS_WITH(FontFace(written(folder, bytes)), Catch::Contains("is damaged: "));

            Bytes changed = whole;
            changed[at] = static_cast<std::uint8_t>(changed[at] ^ (1U << random() % 8));
            // without a checksum: search hints of the directory, padding, the checksum of the whole file
            if (fault_of_font(changed).empty()) { CHECK_NOTHROW(FontFace(written(folder, changed))); }
        }
    }
}

TEST_CASE("what is no font is named with the reason", "[render][fonts]") {
    const TemporaryFolder folder;
    const auto path = written(folder, {});
    CHECK_THROWS_WITH(
        FontFace(path), "font '" + path.string() + "' is damaged: it is not a TrueType or OpenType font");
    CHECK_THROWS_WITH(FontFace(folder.path() / "none.ttf"), Catch::Contains("No such file or directory"));
    // more tables than the file can hold
    CHECK(fault_of_font(Bytes{0, 1, 0, 0, 255, 255, 0, 0, 0, 0, 0, 0}) == "it ends too early");
}

}  // namespace jw::render::test
