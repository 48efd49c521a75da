#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include "render/gl/render_targets.hpp"
#include "render/passes/id_buffer.hpp"
#include "render/scene/framing.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kColumns = 320;
constexpr int kRows = 180;
const Rect kWhole{0.0, 0.0, kColumns, kRows};

/// Context, renderer and ids.
struct Picker {
    Offscreen offscreen{kColumns, kRows, 1};
    SceneRenderer renderer{offscreen.gl()};
    IdBuffer ids{offscreen.gl(), renderer.meshes()};

    bool show(
        const Scene& scene, const Camera& camera, const Rect& viewport = kWhole, std::uint64_t version = 1) {
        return ids.update(scene, camera, viewport, offscreen.size(), version);
    }
    int at(const Camera& camera, const Vector3d& point, const Rect& viewport = kWhole) const {
        const Projected seen = project(camera, viewport, point);
        return ids.nearest_id(seen.x, seen.y, 0.0);
    }
};

Camera camera_for(const Scene& scene, const Rect& viewport = kWhole) {
    return frame_scene(bounds_of(scene), viewport);
}

/// Looks along y, x to the right, z up; 100 pixels are 1 m at the origin.
Camera front_view() {
    Camera camera;
    camera.eye = {0.0, -10.0, 0.0};
    camera.field_of_view = 2.0 * std::atan(0.9 / 10.0);
    return camera;
}

Shape ball(const Vector3d& centre, double radius, int id) {
    Shape shape{Sphere{centre, radius}, palette::kOrange};
    shape.id = id;
    return shape;
}

Arrow arrow(const Vector3d& from, const Vector3d& to, int id) {
    Arrow arrow{from, to, 0.01};
    arrow.id = id;
    return arrow;
}

/// Five bodies and three vectors beside one another; `ids` in this order.
Scene row_of_things(const std::vector<int>& ids) {
    Scene scene;
    Box box;
    box.pose.r = {-1.2, 0.0, 0.0};
    box.half_size.setConstant(0.15);
    scene.shapes = {
        {box, palette::kBlue},
        {Sphere{{-0.8, 0.0, 0.0}, 0.1}, palette::kOrange},
        {Rod{{-0.5, 0.0, -0.2}, {-0.4, 0.1, 0.2}, 0.05}, palette::kGreen},
        {Cylinder{{-0.2, 0.0, -0.2}, {0.0, 0.1, 0.2}, 0.08}, with_alpha(palette::kPurple, 0.4F)},
        {Screw{{0.2, 0.0, -0.2}, {0.2, 0.1, 0.2}, Vector3d::UnitX(), 0.06, 0.04}, palette::kSteel, true}};
    scene.arrows = {
        {{0.5, 0.0, -0.3}, {0.6, 0.0, 0.3}, 0.02},
        {{0.8, 0.0, 0.3}, {0.7, 0.2, -0.3}, 0.02, palette::kVectorJ, true},
        {{1.0, 0.0, -0.2}, {1.3, 0.0, 0.2}, 0.02, palette::kVectorD, false, false}};
    for (std::size_t n = 0; n < scene.shapes.size(); ++n) { scene.shapes[n].id = ids[n]; }
    for (std::size_t n = 0; n < scene.arrows.size(); ++n) { scene.arrows[n].id = ids[5 + n]; }
    return scene;
}

/// A point in the middle of each thing of `row_of_things`; a dashed vector has a dash at its tip.
const std::vector<Vector3d> kMiddles{{-1.2, 0.0, 0.0},       {-0.8, 0.0, 0.0}, {-0.45, 0.05, 0.0},
                                     {-0.1, 0.05, 0.0},      {0.2, 0.05, 0.0}, {0.55, 0.0, 0.0},
                                     {0.704, 0.192, -0.276}, {1.15, 0.0, 0.0}};

}  // namespace

TEST_CASE("every body and vector is hit at its middle, with exactly its id", "[render][ids]") {
    const auto ids = GENERATE(
        std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8},
        std::vector<int>{255, 256, 257, 65535, 65536, 0x123456, 0xFEDCBA, kMostIds});
    const Rect viewport = GENERATE(
        Rect{0.0, 0.0, kColumns, kRows}, Rect{40.0, 20.0, 240.0, 130.0}, Rect{10.4, 7.6, 199.7, 111.2});
    const Scene scene = row_of_things(ids);
    Camera camera = camera_for(scene, viewport);
    camera.orthographic = GENERATE(false, true);
    Picker picker;
    picker.show(scene, camera, viewport);
    for (std::size_t n = 0; n < ids.size(); ++n) {
        CAPTURE(n);
        CHECK(picker.at(camera, kMiddles[n], viewport) == ids[n]);
    }
}

TEST_CASE("no pixel has an id that is not in the scene", "[render][ids]") {
    const std::vector<int> ids{255, 256, 257, 65535, 65536, 0x123456, 0xFEDCBA, kMostIds};
    const Scene scene = row_of_things(ids);
    Picker picker;
    picker.show(scene, camera_for(scene));
    std::set<int> found;
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) { found.insert(picker.ids.nearest_id(x, y, 0.0)); }
    }
    std::set<int> expected(ids.begin(), ids.end());
    expected.insert(0);
    CHECK(found == expected);
}

TEST_CASE("the background, the ground and what is outside the viewport are nothing", "[render][ids]") {
    Scene scene;
    scene.ground = Ground{};
    scene.shapes.push_back(ball({0.0, 0.0, 0.0}, 20.0, 3));
    const Rect viewport{40.0, 20.0, 100.0, 80.0};
    Picker picker;
    CHECK(picker.ids.nearest_id(90.0, 60.0, 0.0) == 0);  // before the first update
    picker.show(scene, front_view(), viewport);
    CHECK(picker.ids.nearest_id(40.5, 20.5, 0.0) == 3);
    CHECK(picker.ids.nearest_id(139.5, 99.5, 0.0) == 3);
    for (const auto& [x, y] :
         {std::pair(39.5, 60.0), {140.5, 60.0}, {90.0, 19.5}, {90.0, 100.5}, {-1e4, 1e4}}) {
        CHECK(picker.ids.nearest_id(x, y, 0.0) == 0);
        CHECK(picker.ids.nearest_id(x, y, 5.0) == 0);
    }
    scene.shapes.clear();
    picker.show(scene, front_view(), viewport, 2);
    CHECK(picker.ids.nearest_id(90.0, 90.0, 0.0) == 0);
}

TEST_CASE("a hidden body does not win, even if the one before it cannot be hit", "[render][ids]") {
    const int front_id = GENERATE(7, 0);
    Scene scene;
    scene.shapes = {ball({0.0, 2.0, 0.0}, 0.3, 1), ball({0.0, 0.0, 0.0}, 0.4, front_id)};
    if (GENERATE(false, true)) { std::swap(scene.shapes[0], scene.shapes[1]); }
    Picker picker;
    picker.show(scene, front_view());
    CHECK(picker.at(front_view(), Vector3d::Zero()) == front_id);
}

TEST_CASE("a vector inside a body is hit if it is seen through it, and not otherwise", "[render][ids]") {
    const bool see_through = GENERATE(true, false);
    const float alpha = GENERATE(1.0F, 0.3F);
    Scene scene;
    scene.shapes = {ball(Vector3d::Zero(), 0.4, 1)};
    scene.shapes[0].colour.a = alpha;
    scene.arrows = {arrow({-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, 2)};
    scene.arrows[0].see_through = see_through;
    Picker picker;
    picker.show(scene, front_view());
    CHECK(picker.at(front_view(), Vector3d::Zero()) == (see_through ? 2 : 1));
}

TEST_CASE("the pointer goes through ghosts, vectors and lines without id", "[render][ids]") {
    Scene scene;
    scene.shapes = {ball(Vector3d::Zero(), 0.3, 1), ball(Vector3d::Zero(), 0.6, 0)};
    scene.shapes[1].colour.a = 0.3F;
    scene.arrows = {arrow({-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}, 0)};
    scene.polylines.push_back({{{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}}, 6.0});
    scene.triads.push_back({});
    Picker picker;
    picker.show(scene, front_view());
    CHECK(picker.at(front_view(), Vector3d::Zero()) == 1);
    CHECK(picker.at(front_view(), {0.45, 0.0, 0.0}) == 0);
}

TEST_CASE("axes and paths are hit", "[render][ids]") {
    Scene scene;
    scene.triads.push_back({Pose{}, 0.5, 0.02});
    scene.triads[0].id = 4;
    scene.polylines.push_back({{{-1.0, 0.0, -0.5}, {0.0, 0.0, -0.5}, {1.0, 0.0, -0.7}}, 12.0});
    scene.polylines[0].id = 5;
    Picker picker;
    picker.show(scene, front_view());
    CHECK(picker.at(front_view(), {0.3, 0.0, 0.0}) == 4);
    CHECK(picker.at(front_view(), {0.0, 0.0, 0.3}) == 4);
    CHECK(picker.at(front_view(), {-0.6, 0.0, -0.5}) == 5);
    CHECK(picker.at(front_view(), {0.5, 0.0, -0.6}) == 5);
    CHECK(picker.at(front_view(), {0.3, 0.0, 0.2}) == 0);
}

TEST_CASE("a pointer that need not be exact prefers thin things, then what is under it", "[render][ids]") {
    Scene scene;
    scene.shapes = {ball({-0.5, 0.0, 0.0}, 0.4, 1)};
    scene.arrows = {arrow({-0.8, 0.0, 0.0}, {1.2, 0.0, 0.0}, 2)};
    Picker picker;
    picker.show(scene, front_view());
    const auto near = [&](const Vector3d& point, double below, double radius) {
        const Projected seen = project(front_view(), kWhole, point);
        return picker.ids.nearest_id(seen.x, seen.y + below, radius);
    };
    const Vector3d on_body{-0.5, 0.0, 0.0};
    CHECK(near(on_body, 6.0, 0.0) == 1);
    CHECK(near(on_body, 6.0, 4.0) == 1);
    CHECK(near(on_body, 6.0, 8.0) == 2);
    const Vector3d beside{0.5, 0.0, 0.0};
    CHECK(near(beside, 5.0, 2.0) == 0);
    CHECK(near(beside, 5.0, 6.0) == 2);
    // 44 pixels below the middle of a ball with a radius of 40 and its outline
    CHECK(near(on_body, 44.0, 0.0) == 0);
    CHECK(near(on_body, 44.0, 6.0) == 1);
}

TEST_CASE("ids cover exactly the pixels that bodies and vectors colour", "[render][ids]") {
    Scene scene = row_of_things({1, 2, 3, 4, 5, 6, 7, 8});
    for (Arrow& arrow : scene.arrows) { arrow.highlighted = GENERATE(false, true); }
    const Camera camera = camera_for(scene);
    Picker picker;
    const auto draw = [&](const Scene& what) {
        picker.offscreen.begin_3d();
        picker.renderer.draw(what, camera, kWhole, picker.offscreen.targets());
        picker.offscreen.begin_2d();
        return picker.offscreen.read();
    };
    const Image bare = draw({});
    const Image full = draw(scene);
    picker.show(scene, camera);
    int covered = 0;
    int disagreeing = 0;
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            const bool coloured = !std::equal(full.at(x, y), full.at(x, y) + 3, bare.at(x, y));
            const bool hit = picker.ids.nearest_id(x + 0.5, y + 0.5, 0.0) != 0;
            covered += hit ? 1 : 0;
            disagreeing += coloured != hit ? 1 : 0;
        }
    }
    CHECK(covered > 3000);
    CHECK(disagreeing == 0);
}

TEST_CASE("ids are drawn anew only when something is another one", "[render][ids]") {
    const Scene scene = row_of_things({1, 2, 3, 4, 5, 6, 7, 8});
    Camera camera = camera_for(scene);
    Picker picker;
    CHECK(picker.show(scene, camera));
    CHECK_FALSE(picker.show(scene, camera));
    CHECK(picker.show(scene, camera, kWhole, 2));
    CHECK_FALSE(picker.show(scene, camera, kWhole, 2));
    camera.eye.x() += 0.1;
    CHECK(picker.show(scene, camera, kWhole, 2));
    CHECK(picker.show(scene, camera, shrunk(kWhole, 10.0), 2));
}

TEST_CASE("picking in the middle of a frame does not touch the picture", "[render][ids]") {
    const Scene scene = row_of_things({1, 2, 3, 4, 5, 6, 7, 8});
    const Camera camera = camera_for(scene);
    Picker picker;
    std::uint64_t version = 0;
    const auto draw = [&](bool pick) {
        const auto look = [&] {
            if (pick) { picker.show(scene, camera, kWhole, ++version); }
            CHECK((picker.at(camera, kMiddles[0]) == 1) == pick);
        };
        picker.offscreen.begin_3d();
        look();
        picker.renderer.draw(scene, camera, kWhole, picker.offscreen.targets());
        look();
        picker.offscreen.begin_2d();
        look();
        return picker.offscreen.read();
    };
    const Image undisturbed = draw(false);
    CHECK(draw(true) == undisturbed);
}

TEST_CASE("in a viewport without pixels nothing is drawn or hit, and no error is left", "[render][ids]") {
    const Scene scene = row_of_things({1, 2, 3, 4, 5, 6, 7, 8});
    const Rect none{100.0, 50.0, 0.0, 0.0};
    Picker picker;
    picker.show(scene, front_view());
    CHECK_FALSE(picker.show(scene, front_view(), none));
    CHECK(picker.ids.nearest_id(100.0, 50.0, 0.0) == 0);
    picker.offscreen.begin_3d();
    picker.renderer.draw(scene, front_view(), none, picker.offscreen.targets());
    picker.offscreen.begin_2d();
    const Image image = picker.offscreen.read();
    CHECK(std::equal(image.rgb.begin() + 3, image.rgb.end(), image.rgb.begin()));
}

TEST_CASE("ids that do not fit three bytes are refused", "[render][ids]") {
    Scene scene;
    scene.arrows = {arrow({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, GENERATE(-1, kMostIds + 1))};
    Picker picker;
    CHECK_THROWS_WITH(picker.show(scene, front_view()), Catch::Contains("is not in 0 to 16777215"));
}

}  // namespace jw::render::test
