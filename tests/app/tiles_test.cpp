#include <algorithm>
#include <cstdlib>
#include <ranges>

#include <catch2/catch.hpp>

#include "app/host/frames/frame_painter.hpp"
#include "app/session/story/story.hpp"
#include "app/session/view/view.hpp"
#include "lessons/read/reader.hpp"
#include "render/files/image_difference.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

constexpr int kStep = 12;

Lesson lesson_of(const std::string& name) { return read_lesson_file(lesson_path(name)).lesson.value(); }

render::Image painted(const Story& story, const host::FrameLook& look, int width, int height) {
    host::FramePainter painter(story, width, height, look);
    return painter.paint(view_of(story, std::min(kStep, static_cast<int>(story.steps().size()) - 1)));
}

host::FrameLook in_tiles(host::FrameLook look, int width) {
    look.tile_width = width;
    return look;
}

/// Checks that pictures agree up to edges rounded to 1/256 of a pixel in each tile: in 720p less than one
/// pixel in 5000 differs. A seam, or a tile shifted by a pixel, is a whole line of them.
void check_alike(const render::Image& whole, const render::Image& tiled) {
    REQUIRE(tiled.width == whole.width);
    REQUIRE(tiled.height == whole.height);
    const render::ImageDifference difference = render::difference_of(whole, tiled, 8);
    CAPTURE(difference.largest, difference.pixels, difference.patch);
    CHECK(difference.pixels < whole.width * whole.height / 5000);
    CHECK(difference.patch <= 4);
}

}  // namespace

TEST_CASE("a frame that is drawn in tiles is the frame that is drawn at once", "[app][frames]") {
    // tiles that fit, that overlap, that are strips, and that are higher than the frame
    for (const int tile : {640, 500, 1280, 333}) {
        INFO("tiles " << tile << " wide");
        for (const char* const name : {"loops/four-bar.toml", "joints/revolute.toml"}) {
            INFO(name);
            const Lesson read = lesson_of(name);
            const Story story(read);
            check_alike(painted(story, {}, 1280, 720), painted(story, in_tiles({}, tile), 1280, 720));
        }
    }
    // the check notices a shift by one pixel
    const Lesson lesson = lesson_of("loops/four-bar.toml");
    const Story story(lesson);
    const render::Image at_once = painted(story, {}, 1280, 720);
    render::Image shifted = at_once;
    std::rotate(shifted.rgb.begin(), shifted.rgb.begin() + 3, shifted.rgb.end());
    CHECK(render::difference_of(at_once, shifted, 8).patch > 4);
}

TEST_CASE("upright, dark and transparent frames are drawn in tiles, too", "[app][frames]") {
    const Lesson lesson = lesson_of("loops/four-bar.toml");
    const Story story(lesson);
    host::FrameLook dark;
    dark.tone = render::Tone::dark;
    check_alike(painted(story, dark, 720, 1280), painted(story, in_tiles(dark, 500), 720, 1280));
    host::FrameLook alone;
    alone.has_panels = alone.is_opaque = false;
    const render::Image whole = painted(story, alone, 640, 360);
    const render::Image tiled = painted(story, in_tiles(alone, 250), 640, 360);
    check_alike(whole, tiled);
    REQUIRE(tiled.alpha.size() == whole.alpha.size());
    const auto differs = std::ranges::count_if(
        std::views::iota(std::size_t{0}, whole.alpha.size()),
        [&](std::size_t k) { return std::abs(int{whole.alpha[k]} - int{tiled.alpha[k]}) > 8; });
    CHECK(differs < 640 * 360 / 5000);
}

}  // namespace jw::test
