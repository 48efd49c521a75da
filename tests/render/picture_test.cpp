#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "render/files/png.hpp"
#include "render/scene/framing.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kPictureWidth = 320;
constexpr int kPictureHeight = 180;
const Rect kWholePicture{0.0, 0.0, kPictureWidth, kPictureHeight};

/// True if the hues agree, whatever the lightness: which channel is strongest and which weakest.
bool looks(const std::uint8_t* pixel, const Colour& colour) {
    const auto order = [](float r, float g, float b) { return std::pair(r > g, g > b); };
    return order(pixel[0], pixel[1], pixel[2]) == order(colour.r, colour.g, colour.b);
}

Scene small_scene() {
    Scene scene;
    scene.ground = Ground{};
    Box box;
    box.pose.r = {0.0, 0.0, 0.5};
    scene.shapes.push_back({box, palette::kOrange});
    scene.shapes.push_back({Rod{{1.0, 0.0, 0.3}, {1.5, 0.8, 0.6}, 0.1}, palette::kBlue, true});
    scene.shapes.push_back({Sphere{{-1.0, 0.0, 0.4}, 0.3}, with_alpha(palette::kGreen, 0.4F)});
    scene.arrows.push_back({{0.0, 0.0, 0.5}, {0.0, -1.2, 0.9}, 0.02, palette::kVectorJ, true});
    scene.triads.push_back({});
    scene.polylines.push_back(
        {{{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.2}, {1.0, 1.0, 0.4}}, 2.0, palette::kPurple});
    return scene;
}

Camera view_of(const Scene& scene, const Rect& viewport = kWholePicture) {
    return frame_scene(bounds_of(scene), viewport);
}

}  // namespace

TEST_CASE("a body appears in its own colour before a pale backdrop", "[render][picture]") {
    const auto colour = GENERATE(from_range(palette::kBodies));
    Scene scene;
    scene.shapes.push_back({Sphere{Vector3d::Zero(), 0.5}, colour});
    const Image image = picture(scene, view_of(scene), kWholePicture, kPictureWidth, kPictureHeight);
    CHECK(looks(image.at(kPictureWidth / 2, kPictureHeight / 2), colour));
    for (const int x : {3, kPictureWidth - 4}) {
        for (const int y : {3, kPictureHeight - 4}) {
            const std::uint8_t* const corner = image.at(x, y);
            CHECK(*std::min_element(corner, corner + 3) > 220);
        }
    }
}

TEST_CASE("two runs give the same bytes", "[render][picture]") {
    const Scene scene = small_scene();
    const auto png = [&] {
        return encode_png(picture(scene, view_of(scene), kWholePicture, kPictureWidth, kPictureHeight));
    };
    CHECK(png() == png());
}

TEST_CASE("one renderer draws the same frame whatever it drew before", "[render][picture]") {
    const Scene scene = small_scene();
    Offscreen offscreen(kPictureWidth, kPictureHeight);
    const SceneRenderer renderer(offscreen.gl());
    const auto draw = [&](const Scene& what) {
        offscreen.begin_3d();
        renderer.draw(what, view_of(scene), kWholePicture, offscreen.targets());
        offscreen.begin_2d();
        return offscreen.read();
    };
    const Image first = draw(scene);
    CHECK_FALSE(draw(Scene{}) == first);
    CHECK(draw(scene) == first);
}

TEST_CASE("a shadow moves with its body and with the light that goes with the camera", "[render][picture]") {
    Scene scene = small_scene();
    Camera camera = view_of(scene);
    Offscreen offscreen(kPictureWidth, kPictureHeight);
    const SceneRenderer renderer(offscreen.gl());
    for (int n = 0; n < 6; ++n) {
        // in turn: the same again, another camera, another position of one body
        if (n % 3 == 1) { camera.eye.x() += 0.7; }
        if (n % 3 == 2) { std::get<Box>(scene.shapes[0].geometry).pose.r.y() += 0.4; }
        offscreen.begin_3d();
        renderer.draw(scene, camera, kWholePicture, offscreen.targets());
        offscreen.begin_2d();
        CHECK(offscreen.read() == picture(scene, camera, kWholePicture, kPictureWidth, kPictureHeight));
    }
}

TEST_CASE("a small sphere is drawn where project says", "[render][picture]") {
    const bool orthographic = GENERATE(false, true);
    const Rect viewport{60.0, 20.0, 200.0, 140.0};
    Framing framing;
    framing.orthographic = orthographic;
    Bounds bounds;
    bounds.include(Vector3d::Zero(), 1.0);
    const Camera camera = frame_scene(bounds, viewport, framing);
    const Vector3d centre =
        GENERATE(Vector3d(0.5, 0.2, 0.4), Vector3d(-0.6, 0.1, -0.3), Vector3d(0.0, -0.7, 0.2));
    Scene scene;
    scene.shapes.push_back({Sphere{centre, 0.08}, palette::kInk});
    const Image image = picture(scene, camera, viewport, kPictureWidth, kPictureHeight);

    double x = 0.0;
    double y = 0.0;
    double count = 0.0;
    for (int row = 0; row < kPictureHeight; ++row) {
        for (int column = 0; column < kPictureWidth; ++column) {
            if (image.at(column, row)[0] < 140) {
                x += column + 0.5;
                y += row + 0.5;
                count += 1.0;
            }
        }
    }
    REQUIRE(count > 20.0);
    const Projected seen = project(camera, viewport, centre);
    // half a pixel: the centroid is that of some 60 pixels, edges are cut at a threshold, and a sphere off
    // the axis is seen as an ellipse
    CHECK(x / count == Approx(seen.x).margin(0.5));
    CHECK(y / count == Approx(seen.y).margin(0.5));
}

TEST_CASE("nothing is drawn outside the viewport", "[render][picture]") {
    const Rect viewport{100.0, 40.0, 120.0, 90.0};
    Scene scene = small_scene();
    const Image image = picture(scene, view_of(scene, viewport), viewport, kPictureWidth, kPictureHeight);
    std::set<std::array<int, 3>> outside;
    for (int y = 0; y < kPictureHeight; ++y) {
        for (int x = 0; x < kPictureWidth; ++x) {
            const std::uint8_t* const p = image.at(x, y);
            if (!viewport.contains(x + 0.5, y + 0.5)) { outside.insert({p[0], p[1], p[2]}); }
        }
    }
    CHECK(outside.size() == 1);
}

TEST_CASE(
    "a vector inside a body shows faintly when it is see-through, and not otherwise", "[render][picture]") {
    Scene scene;
    scene.shapes.push_back({Sphere{Vector3d::Zero(), 0.5}, palette::kSky});
    const Camera camera = view_of(scene);
    const Image body = picture(scene, camera, kWholePicture, kPictureWidth, kPictureHeight);
    const bool see_through = GENERATE(true, false);
    scene.arrows.push_back({{0.0, 0.0, -0.2}, {0.0, 0.0, 0.2}, 0.04, palette::kVectorJ, false, see_through});
    CHECK((picture(scene, camera, kWholePicture, kPictureWidth, kPictureHeight) == body) == !see_through);
}

TEST_CASE("a highlighted vector is thicker and has a halo, through a body as well", "[render][picture]") {
    const Tone tone = GENERATE(Tone::light, Tone::dark);
    const bool inside = GENERATE(false, true);
    Scene scene;
    if (inside) { scene.shapes.push_back({Sphere{Vector3d::Zero(), 0.5}, palette::kSteel}); }
    scene.arrows.push_back({{0.0, 0.0, -0.4}, {0.0, 0.0, 0.4}, 0.02, palette::kVectorI});
    Offscreen offscreen(kPictureWidth, kPictureHeight);
    const SceneRenderer renderer(offscreen.gl());
    Camera camera;
    camera.eye = {0.0, -3.0, 0.0};
    const auto draw = [&] {
        offscreen.begin_3d();
        renderer.draw(scene, camera, kWholePicture, offscreen.targets(), tone);
        offscreen.begin_2d();
        return offscreen.read();
    };
    const Image plain = draw();
    scene.arrows[0].highlighted = true;
    const Image lit = draw();

    const auto across = [&](const auto& counts) {
        int count = 0;
        for (int x = 0; x < kPictureWidth; ++x) { count += counts(x) ? 1 : 0; }
        return count;
    };
    const int row = kPictureHeight / 2 + 10;  // across the shaft
    const auto amber = [&](const Image& image) {
        return across([&](int x) {
            const std::uint8_t* const p = image.at(x, row);
            return p[0] > p[1] + 20 && p[1] > p[2] + 40;
        });
    };
    CHECK(amber(plain) == 0);
    CHECK(amber(lit) >= 2);
    // wider by half of 5 pixels and, on both sides, by a halo of 3.6 / 4 pixels
    const auto changed =
        across([&](int x) { return !std::equal(lit.at(x, row), lit.at(x, row) + 3, plain.at(x, row)); });
    CHECK(changed >= 4);
    CHECK(changed <= 12);
}

TEST_CASE("a ghost lets the body behind it shine through", "[render][picture]") {
    Scene scene;
    scene.shapes.push_back({Sphere{{0.0, 0.0, 0.0}, 0.3}, palette::kOrange});
    Bounds bounds;
    bounds.include(Vector3d::Zero(), 1.0);
    const Camera camera = frame_scene(bounds, kWholePicture);
    const Image solid = picture(scene, camera, kWholePicture, kPictureWidth, kPictureHeight);
    scene.shapes.push_back({Sphere{{0.0, 0.0, 0.0}, 0.6}, with_alpha(palette::kBlue, 0.3F)});
    const Image veiled = picture(scene, camera, kWholePicture, kPictureWidth, kPictureHeight);
    const std::uint8_t* const before = solid.at(kPictureWidth / 2, kPictureHeight / 2);
    const std::uint8_t* const after = veiled.at(kPictureWidth / 2, kPictureHeight / 2);
    CHECK(looks(after, palette::kOrange));
    CHECK(after[2] > before[2]);
    CHECK(after[0] < before[0]);
}

TEST_CASE("a body darkens the ground beside it", "[render][picture]") {
    Scene scene = small_scene();
    const Camera camera = view_of(scene);
    const auto darkness = [&](const Scene& what) {
        const Image image = picture(what, camera, kWholePicture, kPictureWidth, kPictureHeight);
        long sum = 0;
        for (int y = 0; y < kPictureHeight; ++y) {
            for (int x = 0; x < kPictureWidth; ++x) {
                // grey means ground: all bodies of this scene are colourful
                const std::uint8_t* const p = image.at(x, y);
                const auto [least, most] = std::minmax({p[0], p[1], p[2]});
                if (most - least < 25 && most < 205 && most > 120) { ++sum; }
            }
        }
        return sum;
    };
    Scene bare;
    bare.ground = scene.ground;
    CHECK(darkness(bare) < 20);
    CHECK(darkness(scene) > 200);
}

TEST_CASE("sizes that cannot be drawn are refused with the limit", "[render][picture]") {
    CHECK_THROWS_WITH(Offscreen(0, 100), Catch::Contains("a picture of 0 x 100 pixels cannot be drawn"));
    CHECK_THROWS_WITH(Offscreen(100, 1 << 20), Catch::Contains("each side must be 1 to"));
}

TEST_CASE("the renderer says what draws", "[render][picture]") {
    const Offscreen offscreen(16, 16);
    CHECK_THAT(offscreen.renderer(), Catch::Contains("Mesa"));
    CHECK(offscreen.targets().samples() >= 1);
}

TEST_CASE("a driver without a function of OpenGL 3.3 is an error that names it", "[render][picture]") {
    const GlLoader none = [](const char* name) -> void* {
        static int something = 0;
        return std::string_view(name) == "glBlitFramebuffer" ? nullptr : &something;
    };
    CHECK_THROWS_WITH(
        load_gl_functions(none), "the graphics driver lacks parts of OpenGL 3.3: glBlitFramebuffer");
}

}  // namespace jw::render::test
