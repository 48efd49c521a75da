#include "app/panels/frame/frame.hpp"

#include <catch2/catch.hpp>

#include "app/panels/column/column.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/caption.hpp"
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

TEST_CASE("every part keeps to its place, however long its texts are", "[panels][frame]") {
    const auto size = GENERATE(Size{1280, 720}, Size{1920, 1080}, Size{960, 540}, Size{1024, 768});
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
    const auto size = GENERATE(Size{1280, 720}, Size{960, 540});
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
