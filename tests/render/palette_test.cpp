#include <catch2/catch.hpp>

#include <cmath>

#include "render/scene/framing.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

using namespace palette;

/// Angle on the colour wheel of hexagons, in turns: good enough to tell hues apart.
double hue(const Colour& c) {
    const double x = static_cast<double>(c.r) - 0.5 * static_cast<double>(c.g + c.b);
    const double y = std::sqrt(0.75) * static_cast<double>(c.g - c.b);
    return std::atan2(y, x) / (2.0 * M_PI);
}

double linear(float channel) {
    const auto c = static_cast<double>(channel);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const Colour& c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

/// Ratio of luminances from 1 to 21 as WCAG 2 defines it; opaque colours. 4.5 is asked of text, 3 of symbols.
double contrast(const Colour& a, const Colour& b) {
    const double first = luminance(a) + 0.05;
    const double second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

double lightness(const Colour& c) { return contrast(c, from_hex(0x000000)); }

}  // namespace

TEST_CASE("contrast is 21 between black and white and 1 between equals", "[render][palette]") {
    CHECK(contrast(from_hex(0x000000), from_hex(0xFFFFFF)) == Approx(21.0));
    CHECK(contrast(kOrange, kOrange) == Approx(1.0));
    CHECK(
        contrast(from_hex(0x777777), from_hex(0xFFFFFF)) ==
        Approx(4.48).margin(0.005));  // WCAG's own example
}

TEST_CASE("ink can be read on paper in both tones, and vectors told from it", "[render][palette]") {
    const Tone tone = GENERATE(Tone::light, Tone::dark);
    for (const Colour& paper : {kPaper, kPaperShade}) {
        CHECK(contrast(toned(kInk, tone), toned(paper, tone)) >= 7.0);
        CHECK(contrast(toned(kInkSoft, tone), toned(paper, tone)) >= 4.5);
    }
    for (const Colour& behind : {kPaper, kSkyTop, kSkyBottom, kGroundPlane}) {
        for (const Colour& vector : {kVectorI, kVectorJ, kVectorD, kPoint, kAxes[0], kAxes[1], kAxes[2]}) {
            CHECK(contrast(toned(vector, tone), toned(behind, tone)) >= 3.0);
        }
        CHECK(contrast(toned(kInk, tone), toned(behind, tone)) >= 7.0);
    }
}

TEST_CASE("the dark tone turns light into dark and keeps the order, the hue and alpha", "[render][palette]") {
    CHECK(toned(kOrange, Tone::light) == kOrange);
    for (int n = 1; n <= 255; ++n) {
        const auto grey = [](int level) { return from_hex(static_cast<std::uint32_t>(level * 0x010101)); };
        CHECK(lightness(toned(grey(n), Tone::dark)) < lightness(toned(grey(n - 1), Tone::dark)));
    }
    for (const Colour& colour : {kVectorI, kVectorJ, kVectorD, kAxes[0], kAxes[1], kAxes[2], kHighlight}) {
        const Colour dark = toned(with_alpha(colour, 0.25F), Tone::dark);
        CHECK(dark.a == 0.25F);
        // 0.03 turns are 11 degrees; red, green and blue are 120 apart. Lines of equal hue are not straight
        CHECK(std::abs(std::remainder(hue(dark) - hue(colour), 1.0)) < 0.03);
    }
}

TEST_CASE("every colour of the chart has a dark tone that a screen can show", "[render][palette]") {
    for (std::uint32_t r = 0; r <= 255; r += 51) {
        for (std::uint32_t g = 0; g <= 255; g += 51) {
            for (std::uint32_t b = 0; b <= 255; b += 51) {
                const Colour dark = toned(from_hex(r << 16U | g << 8U | b), Tone::dark);
                for (const float c : {dark.r, dark.g, dark.b}) { CHECK((c >= 0.0F && c <= 1.0F)); }
            }
        }
    }
}

TEST_CASE("in the dark the backdrop is dark and bodies keep their colours", "[render][palette]") {
    Scene scene;
    scene.ground = Ground{};
    scene.shapes.push_back({Sphere{{0.0, 0.0, 0.5}, 0.5}, kOrange});
    const Rect whole{0.0, 0.0, 160.0, 90.0};
    const Camera camera = frame_scene(bounds_of(scene), whole);
    Offscreen offscreen(160, 90);
    const SceneRenderer renderer(offscreen.gl());
    const auto draw = [&](Tone tone) {
        offscreen.begin_3d(toned(kPaper, tone));
        renderer.draw(scene, camera, whole, offscreen.targets(), tone);
        offscreen.begin_2d();
        return offscreen.read();
    };
    const Image light = draw(Tone::light);
    const Image dark = draw(Tone::dark);
    CHECK(light == picture(scene, camera, whole, 160, 90));
    const Projected middle = project(camera, whole, {0.0, 0.0, 0.5});
    const auto pixel = [&](const Image& image) {
        const std::uint8_t* const p = image.at(static_cast<int>(middle.x), static_cast<int>(middle.y));
        return std::array{p[0], p[1], p[2]};
    };
    CHECK(pixel(light) == pixel(dark));
    for (const int x : {2, 157}) {
        for (const int y : {2, 87}) {
            CHECK(*std::max_element(dark.at(x, y), dark.at(x, y) + 3) < 70);
            CHECK(*std::min_element(light.at(x, y), light.at(x, y) + 3) > 220);
        }
    }
}

}  // namespace jw::render::test
