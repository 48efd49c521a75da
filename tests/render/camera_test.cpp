#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

Camera some_camera(bool orthographic) {
    Camera camera;
    camera.eye = {3.0, -4.0, 2.5};
    camera.target = {0.2, 0.1, 0.4};
    camera.orthographic = orthographic;
    return camera;
}

}  // namespace

TEST_CASE("project says where the matrices of the renderer put a point", "[render][camera]") {
    const Camera camera = some_camera(GENERATE(false, true));
    const Rect viewport{40.0, 30.0, 600.0, 400.0};
    const Matrix4d clip_from_world =
        projection_matrix(camera, viewport.width / viewport.height) * view_matrix(camera);
    std::mt19937 random(1);
    for (int n = 0; n < 100; ++n) {
        const Vector3d point = random_vector(random, 1.0);
        const Eigen::Vector4d clip = clip_from_world * point.homogeneous();
        const Projected seen = project(camera, viewport, point);
        // 1e-9 pixels: rounding of 1e-16 in coordinates of hundreds, with room
        CHECK(seen.x == Approx(40.0 + 300.0 * (1.0 + clip.x() / clip.w())).margin(1e-9));
        CHECK(seen.y == Approx(30.0 + 200.0 * (1.0 - clip.y() / clip.w())).margin(1e-9));
        CHECK(std::abs(clip.z()) <= clip.w());
    }
}

TEST_CASE("the target is seen in the middle and a point behind the eye is not seen", "[render][camera]") {
    const Camera camera = some_camera(false);
    const Rect viewport{10.0, 20.0, 300.0, 200.0};
    const Projected middle = project(camera, viewport, camera.target);
    CHECK(middle.visible);
    CHECK(middle.x == Approx(160.0));
    CHECK(middle.y == Approx(120.0));
    CHECK(middle.depth == Approx(camera.distance()));
    CHECK_FALSE(project(camera, viewport, 2.0 * camera.eye - camera.target).visible);
}

TEST_CASE("one pixel_size across the view is one pixel on the picture", "[render][camera]") {
    const Camera camera = some_camera(GENERATE(false, true));
    const Rect viewport{0.0, 0.0, 640.0, 360.0};
    const Vector3d point{0.5, -0.3, 0.2};
    const Projected here = project(camera, viewport, point);
    const Projected there =
        project(camera, viewport, point + pixel_size(camera, viewport, point) * axes_of(camera).right);
    CHECK(there.x - here.x == Approx(1.0));
    CHECK(there.y == Approx(here.y));
}

}  // namespace jw::render::test
