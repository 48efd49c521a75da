#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "render/scene/orbit.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

const Rect kWindow{40.0, 30.0, 600.0, 400.0};
// pixels: coordinates of hundreds after some ten roundings of 1e-16, with room for eyes near a pole, where
// results are divided by 1e-3 rad
constexpr double kPixels = 1e-7;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

Camera random_camera(std::mt19937& random) {
    Camera camera;
    camera.target = random_vector(random, 2.0);
    camera.up = random_vector(random, 1.0);
    camera.eye = camera.target + random_vector(random, 5.0);
    camera.field_of_view = uniform(random, 0.3, 1.2);
    camera.orthographic = uniform(random, 0.0, 1.0) < 0.5;
    return camera;
}

double elevation(const Camera& camera) {
    return std::asin((camera.eye - camera.target).normalized().dot(camera.up.normalized()));
}

/// Runs `check` for 100 random cameras; every test of a move uses them.
template <class Check>
void for_random_cameras(const Check& check) {
    std::mt19937 random(7);
    for (int n = 0; n < 100; ++n) { check(random_camera(random), random); }
}

bool seen_at(const Camera& camera, const Vector3d& point, double x, double y) {
    const Projected seen = project(camera, kWindow, point);
    return std::abs(seen.x - x) < kPixels && std::abs(seen.y - y) < kPixels;
}

}  // namespace

TEST_CASE("orbiting keeps target, distance and up, and undoes itself", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937& random) {
        const double dx = uniform(random, -3.0, 3.0);
        const double room = 0.5 * M_PI - 0.01 - std::abs(elevation(camera));
        if (room <= 0.0) { return; }
        const double dy = uniform(random, -room, room);
        const Camera moved = orbited(camera, dx, dy);
        CHECK(moved.target == camera.target);
        CHECK(moved.up == camera.up);
        CHECK(moved.distance() == Approx(camera.distance()));
        CHECK(elevation(moved) == Approx(elevation(camera) + dy).margin(1e-9));
        CHECK((orbited(moved, -dx, -dy).eye - camera.eye).norm() < 1e-9);
    });
}

TEST_CASE("the near side of the scene follows the pointer that orbits", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937&) {
        if (std::abs(elevation(camera)) > 1.2) { return; }
        const Vector3d near_side = camera.target + 0.1 * (camera.eye - camera.target);
        const Projected before = project(camera, kWindow, near_side);
        CHECK(project(orbited(camera, 0.05, 0.0), kWindow, near_side).x > before.x + 0.3);
        CHECK(project(orbited(camera, 0.0, 0.05), kWindow, near_side).y > before.y + 0.3);
    });
}

TEST_CASE("no orbit goes over a pole or loses the picture's axes", "[render][orbit]") {
    for_random_cameras([](Camera camera, std::mt19937& random) {
        for (int n = 0; n < 20; ++n) {
            camera = orbited(camera, uniform(random, -9.0, 9.0), uniform(random, -9.0, 9.0));
            const CameraAxes axes = axes_of(camera);
            CHECK(axes.right.norm() == Approx(1.0));
            CHECK(axes.up.dot(camera.up) > 0.0);
            CHECK(std::abs(elevation(camera)) < 0.5 * M_PI - 0.9e-3);
        }
    });
}

TEST_CASE("a camera that looks along up can be orbited out of it", "[render][orbit]") {
    Camera camera;
    camera.eye = {0.0, 0.0, 4.0};
    camera = orbited(camera, 0.3, -0.5);
    CHECK(elevation(camera) == Approx(0.5 * M_PI - 1e-3 - 0.5));
    CHECK(axes_of(camera).right.norm() == Approx(1.0));
}

TEST_CASE("panning moves the point at the target by the pointer's way", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937& random) {
        const double dx = uniform(random, -300.0, 300.0);
        const double dy = uniform(random, -200.0, 200.0);
        const Camera moved = panned(camera, kWindow, dx, dy);
        CHECK(seen_at(moved, camera.target, 340.0 + dx, 230.0 + dy));
        CHECK((moved.eye - moved.target - camera.eye + camera.target).norm() < 1e-12);
    });
}

TEST_CASE("zooming leaves the point under the pointer and magnifies around it", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937& random) {
        const double x = uniform(random, 40.0, 640.0);
        const double y = uniform(random, 30.0, 430.0);
        const double factor = uniform(random, 0.5, 2.0);
        const Vector3d under = point_at_depth(camera, kWindow, x, y, camera.target);
        const Camera moved = zoomed(camera, kWindow, factor, x, y, camera.distance());
        CHECK(seen_at(moved, under, x, y));
        CHECK(pixel_size(moved, kWindow, under) * factor == Approx(pixel_size(camera, kWindow, under)));
    });
}

TEST_CASE("nobody zooms out of reach, and coming back is always possible", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937&) {
        Camera far = camera;
        Camera near = camera;
        for (int n = 0; n < 200; ++n) {
            far = zoomed(far, kWindow, 0.8, 100.0, 50.0, 2.0);
            near = zoomed(near, kWindow, 1.25, 100.0, 50.0, 2.0);
        }
        CHECK(far.distance() == Approx(20.0));
        CHECK(near.distance() == Approx(0.02));
        // already beyond the range of a smaller scene: the camera does not jump, and can only come back
        CHECK(zoomed(far, kWindow, 0.5, 9.0, 9.0, 0.1).distance() == Approx(20.0));
        CHECK(zoomed(far, kWindow, 2.0, 9.0, 9.0, 0.1).distance() == Approx(10.0));
    });
}

TEST_CASE("standard views show the axes where a drawing has them", "[render][orbit]") {
    using V = StandardView;
    struct Case {
        V view;
        Vector3d up, right, picture_up;
    };
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    const Case c = GENERATE_COPY(
        Case{V::front, z, x, z}, Case{V::back, z, -x, z}, Case{V::right, z, y, z}, Case{V::left, z, -y, z},
        Case{V::top, z, x, y}, Case{V::bottom, z, x, -y}, Case{V::front, y, x, y}, Case{V::right, y, -z, y},
        Case{V::top, y, x, -z}, Case{V::front, x, y, x}, Case{V::top, -z, x, -y});
    Camera camera;
    camera.target = {0.3, 0.2, -0.1};
    camera.up = 2.5 * c.up;
    const Camera seen = standard_view(camera, c.view);
    const CameraAxes axes = axes_of(seen);
    CHECK((axes.right - c.right).norm() < 1e-12);
    CHECK((axes.up - c.picture_up).norm() < 1.1e-3);  // the camera stays 1e-3 rad away from the pole
    CHECK(seen.target == camera.target);
    CHECK(seen.up == camera.up);
    CHECK(seen.distance() == Approx(camera.distance()));
}

TEST_CASE("the isometric view shows three axes equally long, from above", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937&) {
        const CameraAxes axes = axes_of(standard_view(camera, StandardView::isometric));
        const Vector3d up = camera.up.normalized();
        const Vector3d ahead = level_axis(up);
        const double along = -1.0 / std::sqrt(3.0);
        CHECK(up.dot(axes.forward) == Approx(along));
        CHECK(ahead.dot(axes.forward) == Approx(along));
        CHECK(up.cross(ahead).dot(axes.forward) == Approx(-along));
    });
}

TEST_CASE("a blend starts and ends exactly and keeps away from the target between", "[render][orbit]") {
    for_random_cameras([](const Camera& from, std::mt19937& random) {
        Camera to = random_camera(random);
        if (uniform(random, 0.0, 1.0) < 0.7) { to.up = from.up; }
        CHECK(blended(from, to, 0.0).eye == from.eye);
        CHECK(blended(from, to, 1.0).eye == to.eye);
        const double nearest = std::min(from.distance(), to.distance());
        Vector3d eye = from.eye;
        for (int n = 1; n <= 100; ++n) {
            const Camera camera = blended(from, to, n / 100.0);
            CHECK(camera.distance() > nearest * (1.0 - 1e-9));
            CHECK(axes_of(camera).right.norm() == Approx(1.0));
            // no jumps: a hundredth of half a turn about the target, of the target's way, and of an up that
            // turns over as well
            CHECK((camera.eye - eye).norm() < 0.01 * (10.0 * (from.distance() + to.distance()) + 7.0));
            eye = camera.eye;
        }
    });
}

TEST_CASE("from the front to the back a blend goes around, level", "[render][orbit]") {
    const Camera front = standard_view(Camera{}, StandardView::front);
    const Camera back = standard_view(front, StandardView::back);
    const Camera half = blended(front, back, 0.5);
    CHECK(std::abs(half.eye.z() - front.eye.z()) < 1e-9);
    CHECK(half.distance() == Approx(front.distance()));
}

TEST_CASE("a blend between opposite ups turns over once, and keeps its distance", "[render][orbit]") {
    Camera from = standard_view(Camera{}, StandardView::front);
    Camera to = from;
    to.up = -from.up;
    for (int n = 0; n <= 10; ++n) {
        const Camera camera = blended(from, to, n / 10.0);
        CHECK(camera.up.norm() == Approx(1.0));
        CHECK(camera.up.dot(from.up) == Approx(std::cos(std::numbers::pi * n / 10.0)).margin(1e-9));
        CHECK(camera.distance() == Approx(from.distance()));
    }
}

TEST_CASE("what is grabbed stays under the pointer and in its depth", "[render][orbit]") {
    for_random_cameras([](const Camera& camera, std::mt19937& random) {
        const double x = uniform(random, 40.0, 640.0);
        const double y = uniform(random, 30.0, 430.0);
        const Vector3d grabbed = camera.target + random_vector(random, 0.1 * camera.distance());
        const Vector3d dragged = point_at_depth(camera, kWindow, x, y, grabbed);
        CHECK(seen_at(camera, dragged, x, y));
        CHECK(
            project(camera, kWindow, dragged).depth ==
            Approx(project(camera, kWindow, grabbed).depth).margin(1e-9));
        const Projected there = project(camera, kWindow, grabbed);
        CHECK((point_at_depth(camera, kWindow, there.x, there.y, grabbed) - grabbed).norm() < 1e-9);
    });
}

}  // namespace jw::render::test
