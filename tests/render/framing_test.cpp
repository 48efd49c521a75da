#include <catch2/catch.hpp>

#include <algorithm>

#include <Eigen/Geometry>

#include "render/scene/framing.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

const Rect kViewport{0.0, 0.0, 742.0, 720.0};
const Rect kSafe{50.0, 110.0, 600.0, 560.0};

/// Distance [px] of a point inside `safe` from its nearest edge; negative outside.
double clearance(const Projected& seen, const Rect& safe) {
    return std::min(
        {seen.x - safe.x, safe.x + safe.width - seen.x, seen.y - safe.y, safe.y + safe.height - seen.y});
}

Box random_box(std::mt19937& random) {
    Box box;
    box.pose.r = random_vector(random, 5.0);
    box.pose.A =
        Eigen::AngleAxisd(3.0 * random_vector(random, 1.0).x(), random_vector(random, 1.0).normalized())
            .matrix();
    box.half_size = random_vector(random, 1.0).cwiseAbs() + Vector3d::Constant(0.01);
    return box;
}

Framing random_framing(std::mt19937& random) {
    Framing framing;
    do {
        framing.direction = random_vector(random, 1.0);
    } while (framing.direction.normalized().cross(framing.up).norm() < 0.1);
    framing.orthographic = random_vector(random, 1.0).x() > 0.5;
    framing.field_of_view = 0.3 + 0.6 * std::abs(random_vector(random, 1.0).x());
    return framing;
}

}  // namespace

TEST_CASE(
    "frame_scene keeps every corner of random boxes in the safe rectangle, and touches it",
    "[render][framing]") {
    std::mt19937 random(GENERATE(range(1u, 21u)));
    Scene scene;
    for (int n = 0; n < 4; ++n) { scene.shapes.push_back({random_box(random)}); }
    const Framing framing = random_framing(random);
    const Camera camera = frame_scene(bounds_of(scene), kViewport, kSafe, framing);

    double least = 1e9;
    for (const Shape& shape : scene.shapes) {
        const Box& box = std::get<Box>(shape.geometry);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vector3d sign(
                (corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1);
            const Projected seen =
                project(camera, kViewport, box.pose.r + box.pose.A * sign.cwiseProduct(box.half_size));
            CHECK(seen.visible);
            least = std::min(least, clearance(seen, kSafe));
        }
    }
    CHECK(least > -1e-6);  // pixels; rounding only
    // the camera is as near as it can be, unless the clearance in front of the eye decides: never here,
    // as the boxes are spread over 10 m and seen under 50 degrees at most
    CHECK(least < 1e-6);
}

TEST_CASE("round shapes stay in the safe rectangle too", "[render][framing]") {
    std::mt19937 random(GENERATE(range(1u, 11u)));
    const Vector3d from = random_vector(random, 1.0);
    const Vector3d to = random_vector(random, 1.0);
    const double radius = 0.4;
    const Geometry shape = GENERATE_COPY(
        Geometry(Sphere{from, radius}), Geometry(Rod{from, to, radius}), Geometry(Cylinder{from, to, radius}),
        Geometry(Tube{from, to, radius, 0.1}), Geometry(Ring{from, to, radius, 0.05}));
    Scene scene;
    scene.shapes.push_back({shape});
    const Camera camera =
        frame_scene(bounds_of(scene), {0, 0, 320, 240}, {40, 30, 240, 180}, random_framing(random));
    const Image image = picture(scene, camera, {0, 0, 320, 240}, 320, 240);

    // the backdrop is pale: whatever is darker belongs to the body or its outline
    int outside = 0;
    int inside = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool dark = image.at(x, y)[0] < 200;
            // 2 pixels: outline and anti-aliasing
            const bool in_safe = x >= 38 && x < 282 && y >= 28 && y < 212;
            (in_safe ? inside : outside) += dark ? 1 : 0;
        }
    }
    CHECK(outside == 0);
    CHECK(inside > 1000);
}

TEST_CASE("a watch and a crane fill the picture alike", "[render][framing]") {
    const double size = GENERATE(1e-5, 1e-3, 1.0, 1e3);
    Bounds bounds;
    bounds.include(Vector3d::Zero(), size);
    const Camera camera = frame_scene(bounds, kViewport, kSafe);
    // the sphere touches the safe rectangle, so it is about as high as that
    const double pixels = size / pixel_size(camera, kViewport, Vector3d::Zero());
    CHECK(pixels > 0.4 * std::min(kSafe.width, kSafe.height));
}

TEST_CASE("nothing and a single point can be framed", "[render][framing]") {
    Bounds bounds;
    CHECK(project(frame_scene(bounds, kViewport), kViewport, Vector3d::Zero()).visible);
    bounds.include({7.0, 8.0, 9.0});
    const Camera camera = frame_scene(bounds, kViewport);
    CHECK(project(camera, kViewport, {7.0, 8.0, 9.0}).x == Approx(371.0));
    CHECK(camera.distance() < 1.0);
}

TEST_CASE("a rectangle without room and a direction along up are refused", "[render][framing]") {
    CHECK_THROWS_AS(frame_scene(Bounds(), kViewport, Rect{0, 0, -1, 5}), std::invalid_argument);
    Framing framing;
    framing.direction = -2.0 * framing.up;
    CHECK_THROWS_AS(frame_scene(Bounds(), kViewport, framing), std::invalid_argument);
    framing.direction.setZero();
    CHECK_THROWS_AS(frame_scene(Bounds(), kViewport, framing), std::invalid_argument);
}

TEST_CASE("the ground lies below everything, in a round grid", "[render][framing]") {
    std::mt19937 random(GENERATE(range(1u, 6u)));
    const double size = GENERATE(0.02, 1.0, 300.0);
    Bounds bounds;
    std::vector<Vector3d> points;
    for (int n = 0; n < 5; ++n) { points.push_back(random_vector(random, size)); }
    for (const Vector3d& point : points) { bounds.include(point); }
    const Ground ground = ground_below(bounds, random_vector(random, 3.0));

    for (const Vector3d& point : points) { CHECK(ground.normal.dot(point - ground.point) > 0.0); }
    const double digit = ground.grid / std::pow(10.0, std::floor(std::log10(ground.grid) + 1e-9));
    CHECK((digit == Approx(1.0) || digit == Approx(2.0) || digit == Approx(5.0)));
    CHECK(ground.radius > bounds.diagonal());
    CHECK(ground.grid < 0.25 * bounds.diagonal());
}

}  // namespace jw::render::test
