#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "render/passes/shadow_map.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

const Rect kShadowViewport{40.0, 30.0, 600.0, 400.0};
const Vector3d kUp = Vector3d::UnitZ();
constexpr double kBorder = 0.006;

/// Point where a ray from the light through `point` meets the plane z = height.
Vector3d shadow_of(const Vector3d& point, const Vector3d& towards_light, double height) {
    return point - towards_light * ((point.z() - height) / towards_light.z());
}

Rect shadow_seen(
    const ShadowView& view, const Camera& camera, const Vector3d& point, const Vector3d& normal) {
    return seen_part(
        bounds_of(shadow_on_plane(view, kBorder, point, normal).value()), camera, kShadowViewport);
}

}  // namespace

TEST_CASE("no shadow falls outside of the part of the picture that is named", "[render][shadow]") {
    std::mt19937 random(3);
    int inside = 0;
    for (int n = 0; n < 200; ++n) {
        const Vector3d light = (random_vector(random, 0.7) + kUp).normalized();
        const double height = -1.0 + 0.5 * random_vector(random, 1.0).x();
        Bounds casters;
        std::vector<Vector3d> points;
        for (int k = 0; k < 3; ++k) {
            const Vector3d centre = random_vector(random, 1.0);
            casters.include(centre, 0.3);
            points.push_back(centre + 0.3 * random_vector(random, 1.0).normalized());
        }
        Camera camera;
        camera.eye = random_vector(random, 6.0) + 4.0 * kUp;
        camera.orthographic = n % 2 == 0;
        const ShadowView view = shadow_view(casters, light, 1024);
        const Rect part = shadow_seen(view, camera, {5.0, 2.0, height}, 2.0 * kUp);
        for (const Vector3d& point : points) {
            const Projected seen = project(camera, kShadowViewport, shadow_of(point, light, height));
            if (!seen.visible) { continue; }
            CHECK(part.contains(seen.x, seen.y));
            ++inside;
        }
    }
    CHECK(inside > 200);
}

TEST_CASE("the part where shadow can fall is little more than the shadow", "[render][shadow]") {
    Bounds casters;
    casters.include({0.0, 0.0, 0.5}, 0.5);
    Camera camera;
    camera.eye = {0.0, -0.01, 10.0};
    const ShadowView view = shadow_view(casters, kUp, 1024);
    const Rect part = shadow_seen(view, camera, Vector3d::Zero(), kUp);
    const double pixels = 1.0 / pixel_size(camera, kShadowViewport, Vector3d::Zero());
    // border and margin of 0.016 of the map on each side, whose width is up to 1.15 x 1.25 diagonals of a
    // cube around the ball; 2 pixels of rounding on each side
    const double most = (1.0 + 2.0 * 0.016 * 1.15 * 1.25 * std::sqrt(3.0)) * pixels + 4.0;
    CHECK(part.width >= pixels);
    CHECK(part.width <= most);
    CHECK(part.height >= pixels);
    CHECK(part.height <= most);
}

TEST_CASE("nothing casts no shadow, and where none can be ruled out it is looked for", "[render][shadow]") {
    const Camera camera;
    const ShadowView nothing = shadow_view(Bounds{}, kUp, 1024);
    CHECK(nothing.empty());
    Bounds casters;
    casters.include(Vector3d::Zero(), 0.5);
    const ShadowView grazing = shadow_view(casters, Vector3d(1.0, 0.0, 0.01).normalized(), 1024);
    CHECK_FALSE(shadow_on_plane(grazing, kBorder, Vector3d::Zero(), kUp));
    Bounds behind;
    behind.include(2.0 * camera.eye, 0.5);
    const ShadowView overhead = shadow_view(behind, kUp, 1024);
    CHECK(shadow_seen(overhead, camera, 2.0 * camera.eye, kUp) == kShadowViewport);
}

}  // namespace jw::render::test
