#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "render/passes/id_buffer.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kWide = 240;
constexpr int kHigh = 160;

struct Hit {
    int id = 0;
    double distance = 0.0;  ///< along the view [m]
};

/// First hit of a ray through the middle of a pixel, computed without OpenGL.
Hit cast(const std::vector<Shape>& balls, const Camera& camera, const Rect& viewport, int x, int y) {
    const CameraAxes axes = axes_of(camera);
    const double high = std::tan(0.5 * camera.field_of_view) * camera.distance();
    const double right =
        (2.0 * (x + 0.5 - viewport.x) / viewport.width - 1.0) * high * viewport.width / viewport.height;
    const double up = (1.0 - 2.0 * (y + 0.5 - viewport.y) / viewport.height) * high;
    const Vector3d aside = right * axes.right + up * axes.up;
    const Vector3d from = camera.orthographic ? Vector3d(camera.eye + aside) : camera.eye;
    const Vector3d along = camera.orthographic
                               ? axes.forward
                               : Vector3d((camera.distance() * axes.forward + aside).normalized());
    Hit first;
    double nearest = 1e30;
    for (const Shape& shape : balls) {
        const auto& sphere = std::get<Sphere>(shape.geometry);
        const Vector3d to = sphere.centre - from;
        const double middle = to.dot(along);
        const double under = sphere.radius * sphere.radius - (to.squaredNorm() - middle * middle);
        if (under < 0.0) { continue; }
        const double t = middle - std::sqrt(under);
        if (t >= nearest) { continue; }
        nearest = t;
        first = {shape.id, t * along.dot(axes.forward)};
    }
    return first;
}

std::vector<Shape> random_balls(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1.2, 1.2);
    std::uniform_real_distribution<double> size(0.15, 0.45);
    std::vector<Shape> balls;
    for (int id = 1; id <= 6; ++id) {
        Shape shape{Sphere{{place(random), place(random), place(random)}, size(random)}};
        shape.id = id;
        balls.push_back(shape);
    }
    return balls;
}

}  // namespace

TEST_CASE("layers have the ids and depths that rays meet", "[layers]") {
    Offscreen offscreen(kWide, kHigh, 1);
    SceneRenderer renderer(offscreen.gl());
    IdBuffer buffer(offscreen.gl(), renderer.meshes());
    constexpr unsigned seed = 3;
    std::mt19937 random(seed);
    INFO("seed " << seed);
    for (int trial = 0; trial < 8; ++trial) {
        Scene scene;
        scene.shapes = random_balls(random);
        Camera camera;
        camera.eye = 6.0 * Vector3d(std::cos(0.7 * trial), std::sin(0.7 * trial), 0.5).normalized();
        camera.orthographic = trial % 2 == 1;
        const Rect viewport{10.0, 20.0, 200.0, 120.0};
        buffer.update(scene, camera, viewport, offscreen.size(), static_cast<std::uint64_t>(trial) + 1);
        const PictureLayers layers = buffer.read_layers();
        REQUIRE(layers.width == kWide);
        REQUIRE(layers.height == kHigh);
        int other_ids = 0;
        int other_depths = 0;
        int seen = 0;
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                const auto k = static_cast<std::size_t>(y * kWide + x);
                if (!viewport.contains(x + 0.5, y + 0.5)) {
                    CHECK(layers.ids[k] == 0);
                    continue;
                }
                const Hit hit = cast(scene.shapes, camera, viewport, x, y);
                seen += hit.id != 0;
                if (layers.ids[k] != hit.id) {
                    ++other_ids;
                    continue;
                }
                if (hit.id == 0) { continue; }
                const double distance = layers.depth[k] * camera.distance() / PictureLayers::kDepthOfTarget;
                // the flat triangles of a ball lie inside it by less than this, except at the rim
                other_depths += std::abs(distance - hit.distance) > 0.02;
            }
        }
        INFO("trial " << trial << ": " << seen << " seen, ids " << other_ids << ", depths " << other_depths);
        CHECK(seen > 1000);
        // they differ at rims: those of six balls are some 400 pixels long
        CHECK(other_ids < seen / 20);
        CHECK(other_depths < seen / 20);
    }
}

TEST_CASE("layers that nothing is drawn into are empty", "[layers]") {
    Offscreen offscreen(kWide, kHigh, 1);
    SceneRenderer renderer(offscreen.gl());
    IdBuffer buffer(offscreen.gl(), renderer.meshes());
    buffer.update({}, Camera{}, {0.0, 0.0, kWide, kHigh}, offscreen.size(), 1);
    const PictureLayers layers = buffer.read_layers();
    CHECK(std::ranges::count(layers.ids, 0) == kWide * kHigh);
    CHECK(std::ranges::count(layers.depth, 0) == kWide * kHigh);
}

}  // namespace jw::render::test
