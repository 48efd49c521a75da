#include <catch2/catch.hpp>

#include <array>

#include "render/passes/instances.hpp"
#include "render/passes/scene_view.hpp"
#include "render/scene/framing.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 120;
const Rect kView{20.0, 10.0, 160.0, 100.0};

double random_size(std::mt19937& random, double most) {
    return std::abs(random_vector(random, most).x()) + 0.02;
}

/// One object of each kind at random places; some are seen through bodies, some highlighted, some ghosts.
Scene random_scene(std::mt19937& random) {
    const auto at = [&] { return random_vector(random, 1.0); };
    const Geometry all[] = {
        Box{{Matrix3d::Identity(), at()}, Vector3d(random_size(random, 0.4), 0.1, 0.3)},
        Sphere{at(), random_size(random, 0.3)},
        Cylinder{at(), at(), random_size(random, 0.2)},
        Rod{at(), at(), random_size(random, 0.1)},
        Tube{at(), at(), 0.2, 0.1},
        Ring{at(), at(), 0.4, 0.03},
        Screw{at(), at(), Vector3d::UnitX(), 0.1, 0.06},
        Nut{at(), at(), Vector3d::UnitX(), 0.2, 0.1}};
    Scene scene;
    for (const Geometry& geometry : all) {
        const bool seen_through = random() % 4 == 0;
        scene.shapes.push_back({geometry, palette::kBlue, random() % 3 == 0, seen_through});
        if (random() % 4 == 0) { scene.shapes.back().colour.a = 0.4F; }
        if (random() % 3 == 0) { scene.shapes.pop_back(); }
    }
    scene.arrows.push_back({at(), at(), 0.03, palette::kVectorI, random() % 2 == 0});
    scene.arrows.back().highlighted = random() % 2 == 0;
    scene.triads.push_back({{Matrix3d::Identity(), at()}});
    scene.polylines.push_back({{at(), at(), at()}, 6.0, palette::kInk, random() % 2 == 0});
    return scene;
}

/// Scene with the smallest objects that can be drawn in front of two corners of the viewport, so that all of
/// the viewport counts as drawn into.
Scene with_specks(Scene scene, const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    const double pixel = pixel_size(camera, kView, camera.target);
    for (const double side : {-1.0, 1.0}) {
        const Vector3d corner =
            camera.target + side * pixel * (0.5 * kView.width * axes.right + 0.5 * kView.height * axes.up);
        Polyline speck;
        speck.points = {corner, corner + 1e-6 * axes.right};
        speck.width = 0.1;
        scene.polylines.push_back(speck);
    }
    return scene;
}

}  // namespace

TEST_CASE("drawing only where bodies are leaves nothing of them out", "[render][backdrop]") {
    std::mt19937 random(20261125);
    Offscreen offscreen(kWidth, kHeight);
    const SceneRenderer renderer(offscreen.gl());
    const auto draw = [&](const Scene& scene, const Camera& camera, Tone tone) {
        offscreen.begin_3d();
        renderer.draw(scene, camera, kView, offscreen.targets(), tone);
        offscreen.begin_2d();
        return offscreen.read();
    };
    int smaller = 0;
    for (int n = 0; n < 150; ++n) {
        CAPTURE(n);
        const Scene scene = random_scene(random);
        Camera camera;
        camera.target = random_vector(random, 0.5);
        // far away, near, and among the bodies
        camera.eye = camera.target +
                     random_vector(
                         random, n % 3 == 0   ? 12.0
                                 : n % 3 == 1 ? 5.0
                                              : 1.0) +
                     Vector3d(0.0, 0.05, 0.0);
        camera.orthographic = n % 2 == 0;
        const Tone tone = n % 5 == 0 ? Tone::dark : Tone::light;
        const SceneView view(scene, camera, kView, offscreen.size());
        smaller += seen_part(bounds_of(view.lists), camera, kView).width < 0.7 * kView.width ? 1 : 0;

        const Image part = draw(scene, camera, tone);
        const Image whole = draw(with_specks(scene, camera), camera, tone);
        int different = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool at_corner = std::min(std::abs(x - 20), std::abs(x - 180)) < 4 &&
                                       std::min(std::abs(y - 10), std::abs(y - 110)) < 4;
                const bool equal = std::equal(part.at(x, y), part.at(x, y) + 3, whole.at(x, y));
                different += equal || at_corner ? 0 : 1;
            }
        }
        CHECK(different == 0);
    }
    CHECK(smaller > 20);
}

TEST_CASE("a picture does not depend on what was drawn before it", "[render][backdrop]") {
    std::mt19937 random(7);
    Offscreen offscreen(kWidth, kHeight);
    const SceneRenderer renderer(offscreen.gl());
    const Scene one = random_scene(random);
    const Scene other = random_scene(random);
    const Camera usual = frame_scene(bounds_of(one), kView);
    Camera turned = usual;
    turned.eye = turned.target + Vector3d(-2.0, 4.0, 3.0);
    for (int n = 0; n < 60; ++n) {
        CAPTURE(n);
        Scene scene = random() % 2 == 0 ? one : other;
        if (random() % 4 != 0) { scene.ground = ground_below(bounds_of(one)); }
        if (random() % 4 == 0) { scene.shapes.clear(); }
        const Camera& camera = random() % 3 == 0 ? turned : usual;
        const Tone tone = random() % 3 == 0 ? Tone::dark : Tone::light;
        const Backdrop backdrop = random() % 3 == 0 ? Backdrop::paper : Backdrop::sky;
        const Rect view = random() % 4 == 0 ? Rect{0.0, 0.0, 90.0, 120.0} : kView;
        const Colour paper = random() % 2 == 0 ? palette::kPaper : Colour{0.0F, 0.0F, 0.0F, 0.0F};
        if (random() % 6 == 0) { offscreen.resize(kWidth + static_cast<int>(random() % 2), kHeight); }
        const auto draw = [&](const SceneRenderer& by) {
            offscreen.begin_3d(paper);
            by.draw(scene, camera, view, offscreen.targets(), tone, backdrop);
            offscreen.begin_2d();
            return offscreen.read(false);
        };
        const SceneRenderer fresh(offscreen.gl());
        const Image expected = draw(fresh);
        CHECK(draw(renderer) == expected);
        CHECK(draw(renderer) == expected);
    }
}

TEST_CASE("without ground, paper behind bodies stays what it was", "[render][backdrop]") {
    Scene scene;
    scene.shapes.push_back({Sphere{Vector3d::Zero(), 0.5}, palette::kBlue});
    Offscreen offscreen(kWidth, kHeight);
    const SceneRenderer renderer(offscreen.gl());
    offscreen.begin_3d({0.0F, 0.0F, 0.0F, 0.0F});
    renderer.draw(
        scene, frame_scene(bounds_of(scene), kView), kView, offscreen.targets(), Tone::light,
        Backdrop::paper);
    offscreen.begin_2d();
    const Image image = offscreen.read(false);
    const auto opacity = [&](int x, int y) {
        return image.alpha[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
    };
    CHECK(opacity(100, 60) == 255);
    CHECK(opacity(30, 15) == 0);
    CHECK(opacity(5, 5) == 0);
}

}  // namespace jw::render::test
