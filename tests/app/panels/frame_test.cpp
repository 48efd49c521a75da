#include "app/panels/frame/frame.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "app/panels/column/panels.hpp"
#include "app/panels/frame/annotations.hpp"
#include "tests/app/panels/support.hpp"
#include "tests/app/panels/views.hpp"

namespace jw::panels::test {

namespace {

using Kind = Step::Kind;
constexpr Kind kKinds[] = {Kind::bodies,    Kind::equations, Kind::iteration,
                           Kind::assembled, Kind::failed,    Kind::motion};

std::vector<View> views_of(Kind kind) {
    return {four_bar(kind), screw(kind), only_bodies(kind), overlong(kind)};
}

Picture crowded_picture() {
    Picture picture;
    for (int k = 0; k < 12; ++k) {
        const Vec3 at(0.3 * (k % 4), 0.2 * (k / 4), 0.1 * (k % 3));
        picture.annotations.push_back(
            {at, Vec3::UnitZ(), "\\mathbf{s}_i^P", render::palette::kVectorI, false});
        picture.annotations.push_back({at, -Vec3::UnitZ(), "a body", render::palette::kInk, true});
        picture.scene.arrows.push_back({at, at + Vec3(0.0, 0.0, 0.2)});
    }
    return picture;
}

}  // namespace

TEST_CASE("the parts of a frame tile it, and what is safe is well inside the scene", "[panels][frame]") {
    const auto size = GENERATE(
        Size{960, 540}, Size{1280, 720}, Size{1920, 1080}, Size{1024, 768}, Size{3840, 2160},
        Size{1366, 768});
    const FrameLayout layout = layout_of(size.width, size.height);
    const Box scene = box_of(layout.scene);
    const Box frame{0.0F, 0.0F, static_cast<float>(size.width), static_cast<float>(size.height)};
    const Box parts[] = {scene, layout.title, layout.caption, layout.column};
    float area = 0.0F;
    for (const Box& a : parts) {
        CHECK(frame.contains(a));
        area += a.width * a.height;
        for (const Box& b : parts) { CHECK((&a == &b || !overlap(a, b))); }
    }
    CHECK(area == Approx(frame.width * frame.height));
    CHECK(scene.contains(box_of(layout.scene_safe)));
    CHECK(layout.scene_safe.width > 0.8 * layout.scene.width);
    CHECK(layout.column.width == Approx(0.4 * size.width).margin(1.0));
}

TEST_CASE("a frame that is clearly higher than wide stands upright, and no other", "[panels][frame]") {
    CHECK(layout_of(1080, 1920).upright);
    CHECK(layout_of(1170, 2300).upright);
    CHECK(layout_of(1536, 2048).upright);
    CHECK(layout_of(1000, 1200).upright);
    CHECK_FALSE(layout_of(1000, 1199).upright);
    CHECK_FALSE(layout_of(1024, 1024).upright);
    CHECK_FALSE(layout_of(2532, 1170).upright);
    const FrameLayout layout = layout_of(1080, 1920);
    const Box parts[] = {layout.title, box_of(layout.scene), layout.caption, layout.column};
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(parts[k].x == 0.0F);
        CHECK(parts[k].width == 1080.0F);
        CHECK(parts[k].height > 0.1F * parts[0].width);
        if (k > 0) { CHECK(parts[k].y == parts[k - 1].bottom()); }
    }
}

TEST_CASE(
    "the parts of any frame lie beside each other and cover it, at any size of text on any screen",
    "[panels][frame]") {
    std::mt19937 numbers(20);
    const auto upto = [&](int most) { return static_cast<int>(numbers() % static_cast<unsigned>(most)); };
    int upright = 0;
    for (int k = 0; k < 20000; ++k) {
        const Size size{320 + upto(3000), 200 + upto(3000)};
        const Looking looking{static_cast<float>(upto(9)) / 2.0F, 0.75F + static_cast<float>(upto(7)) / 8.0F};
        const FrameKind kind = upto(2) == 0 ? FrameKind::window : FrameKind::picture;
        const Box frame{0.0F, 0.0F, static_cast<float>(size.width), static_cast<float>(size.height)};
        const float scale = scale_on_screen(size.width, size.height, looking);
        const FrameLayout layout = layout_in(frame, kind, scale, looking.density);
        upright += layout.upright ? 1 : 0;
        const Box parts[] = {layout.title, box_of(layout.scene), layout.caption,
                             layout.tabs,  layout.column,        layout.bar};
        double area = 0.0;
        bool apart = true;
        bool inside = true;
        for (const Box& a : parts) {
            inside = inside && frame.contains(a) && a.width >= 0.0F && a.height >= 0.0F;
            area += static_cast<double>(a.width) * static_cast<double>(a.height);
            for (const Box& b : parts) { apart = apart && (&a == &b || !overlap(a, b)); }
        }
        CAPTURE(size.width, size.height, looking.density, looking.text, static_cast<int>(kind));
        REQUIRE(apart);
        REQUIRE(inside);
        // whole pixels, except for rounding of their products in float
        REQUIRE(
            area == Approx(static_cast<double>(size.width) * static_cast<double>(size.height)).epsilon(1e-6));
        REQUIRE(box_of(layout.scene).contains(box_of(layout.scene_safe)));
        if (kind == FrameKind::window) { REQUIRE(layout.bar.height > 0.0F); }
    }
    // neither kind is rare
    CHECK(upright > 4000);
    CHECK(upright < 16000);
}

TEST_CASE("letters and what is pressed are as large as a hand needs them", "[panels][frame]") {
    constexpr float small = 14.0F;  // see render::Fonts
    struct Screen {
        Size page;  ///< pixels of a page
        float density;
    };
    // phones and tablets, some of their height taken by the browser
    const auto [page, density] = GENERATE(
        Screen{{390, 844}, 3.0F}, Screen{{390, 600}, 3.0F}, Screen{{360, 560}, 2.0F},
        Screen{{412, 732}, 2.625F}, Screen{{375, 550}, 2.0F}, Screen{{820, 1180}, 2.0F},
        Screen{{768, 930}, 2.0F}, Screen{{844, 390}, 3.0F}, Screen{{740, 320}, 2.0F});
    const auto pixels = [&](int length) {
        return static_cast<int>(std::lround(density * static_cast<float>(length)));
    };
    const int width = pixels(page.width);
    const int height = pixels(page.height);
    const bool upright = page.height > page.width;
    // a phone on its side has no room for larger letters
    const float least = upright ? 11.0F : 9.0F;
    CAPTURE(page.width, page.height, density);
    const float usual = small * scale_on_screen(width, height, {density, 1.0F}) / density;
    CHECK(usual >= least);
    // not larger than in an ordinary page
    CHECK(usual <= 14.0F);
    CHECK(small * scale_on_screen(width, height, {density, 1.5F}) / density >= usual);
    const Box frame{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    for (const float text : {0.75F, 1.0F, 1.5F}) {
        const float scale = scale_on_screen(width, height, {density, text});
        const FrameLayout layout = layout_in(frame, FrameKind::window, scale, density);
        REQUIRE(layout.upright == upright);
        CHECK(layout.for_fingers);
        if (!upright) { continue; }
        CHECK(layout.tabs.height >= 40.0F * density - 1.0F);
        // buttons, and a line of steps above them
        CHECK(layout.bar.height >= 40.0F * density + 40.0F * scale);
        // a part of both is visible
        CHECK(layout.scene.height >= 80.0 * static_cast<double>(density));
        CHECK(layout.column.height >= 80.0F * density);
    }
}

TEST_CASE(
    "letters of a picture of a phone are as large as those of a phone of unknown density",
    "[panels][frame]") {
    // for a page that is 390 pixels wide
    CHECK(14.0F * scale_of(1170, 2300) / 3.0F > 11.0F);
    CHECK(14.0F * scale_of(1080, 1920) / (1080.0F / 390.0F) > 11.0F);
    CHECK(scale_on_screen(1170, 2300, {}) == scale_of(1170, 2300));
    // the scale of a frame that is not upright does not need the screen
    CHECK(scale_of(1280, 720) == 1.0F);
    CHECK(scale_of(2532, 1170) == 1.625F);
    CHECK(scale_on_screen(1280, 720, {1.0F, 1.0F}) == 1.0F);
    CHECK_FALSE(layout_in({0.0F, 0.0F, 1280.0F, 720.0F}, FrameKind::window, 1.0F, 1.0F).for_fingers);
}

TEST_CASE("every part keeps to its place, however long its texts are", "[panels][frame]") {
    const auto size = GENERATE(
        Size{1280, 720}, Size{1920, 1080}, Size{960, 540}, Size{1024, 768}, Size{1080, 1920}, Size{480, 800},
        Size{720, 900});
    Surface surface(size);
    const FrameLayout layout = layout_of(size.width, size.height);
    for (const Kind kind : kKinds) {
        for (const View& view : views_of(kind)) {
            CAPTURE(size.width, static_cast<int>(kind), view.matrix.rows.size());
            surface.clear();
            draw_title(surface.canvas(), layout.title, view);
            CHECK(layout.title.contains(surface.drawn()));
            surface.clear();
            draw_caption(surface.canvas(), layout.caption, view);
            CHECK(layout.caption.contains(surface.drawn()));
            surface.clear();
            draw_column(surface.canvas(), layout.column, view);
            CHECK(layout.column.contains(surface.drawn()));
        }
    }
}

TEST_CASE("a caption as high as it asks for leaves no sentence out", "[panels][frame]") {
    Surface surface;
    const Box place = layout_of(1280, 720).caption;
    const auto letters = [&](const View& view, float height) {
        surface.clear();
        draw_caption(surface.canvas(), {place.x, place.y, place.width, height}, view);
        return surface.vertices();
    };
    for (const Kind kind : kKinds) {
        for (const View& view : views_of(kind)) {
            const float height = caption_height(surface.canvas(), place, view);
            CAPTURE(static_cast<int>(kind), height);
            CHECK(height >= place.height);
            CHECK(letters(view, height) == letters(view, height + 5000.0F));
        }
    }
    const View long_one = overlong(Kind::motion);
    CHECK(letters(long_one, place.height) < letters(long_one, 5000.0F));
}

TEST_CASE("a column as high as it asks for shows every panel", "[panels][frame]") {
    const auto size = GENERATE(Size{1280, 720}, Size{960, 540}, Size{1080, 1920});
    const Surface surface(size);
    const Canvas canvas = surface.canvas();
    const Box place = layout_of(size.width, size.height).column;
    for (const Kind kind : kKinds) {
        for (const View& view : views_of(kind)) {
            const float height = column_height(canvas, place, view);
            const std::vector<Block> blocks = blocks_of(canvas, view);
            const Box inner = shrunk({0.0F, 0.0F, place.width, height}, canvas.px(16.0F), canvas.px(14.0F));
            const Arrangement whole = arrange(canvas, inner, blocks);
            for (std::size_t k = 0; k < blocks.size(); ++k) {
                const bool whim = height == place.height && blocks[k].given_up == 1;
                const float least = blocks[k].fills && !whim ? blocks[k].least[2] : 0.0F;
                CAPTURE(size.width, static_cast<int>(kind), k);
                CHECK(whole.boxes[k].height >= least);
            }
        }
    }
}

TEST_CASE("labels of the picture stay in it", "[panels][frame]") {
    Surface surface;
    const FrameLayout layout = layout_of(1280, 720);
    const render::Camera camera;
    draw_annotations(surface.canvas(), crowded_picture(), camera, layout.scene);
    REQUIRE(surface.vertices() > 0);
    CHECK(box_of(layout.scene).contains(surface.drawn()));
}

TEST_CASE("a frame drawn twice is the same, vertex by vertex", "[panels][frame]") {
    const auto vertices = [] {
        const Surface surface;
        const Picture picture = crowded_picture();
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushClipRectFullScreen();
        draw_frame(
            Canvas(&list, surface.fonts()), four_bar(Kind::assembled), picture, render::Camera{},
            layout_of(1280, 720));
        std::vector<float> numbers;
        for (const ImDrawVert& vertex : list.VtxBuffer) {
            numbers.insert(numbers.end(), {vertex.pos.x, vertex.pos.y, vertex.uv.x, vertex.uv.y});
            numbers.push_back(static_cast<float>(vertex.col >> 8U));
        }
        return numbers;
    };
    const std::vector<float> first = vertices();
    CHECK(first.size() > 1000);
    CHECK(first == vertices());
}

}  // namespace jw::panels::test
