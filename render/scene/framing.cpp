#include "render/scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

// Minimum distance of the eye from the scene, in depths of the scene: beyond the camera's near plane.
constexpr double kClearance = 0.15;
constexpr double kNearest = 0.05;    // of the camera's distance: nearer parts are not drawn
constexpr double kPoint = 1e-7;      // [m] smaller scenes count as a point
constexpr double kPointSize = 0.01;  // [m] a point is shown like a body of 1 cm

struct Include {
    Bounds& bounds;

    void operator()(const Box& box) const {
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vector3d sign(
                (corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1);
            bounds.include(box.pose.r + box.pose.A * sign.cwiseProduct(box.half_size));
        }
    }
    void operator()(const Sphere& sphere) const { bounds.include(sphere.centre, sphere.radius); }
    void operator()(const Cylinder& bar) const { disc_ends(bar.from, bar.to, bar.radius); }
    void operator()(const Rod& rod) const {
        bounds.include(rod.from, rod.radius);
        bounds.include(rod.to, rod.radius);
    }
    void operator()(const Tube& tube) const { disc_ends(tube.from, tube.to, tube.outer_radius); }
    void operator()(const Ring& ring) const { disc(ring.centre, ring.axis, ring.radius, ring.wire_radius); }
    void operator()(const Screw& screw) const { disc_ends(screw.from, screw.to, screw.radius); }
    void operator()(const Nut& nut) const { disc_ends(nut.from, nut.to, nut.corner_radius); }

    void disc_ends(const Vector3d& from, const Vector3d& to, double radius) const {
        disc(from, to - from, radius, 0.0);
        disc(to, to - from, radius, 0.0);
    }
    /// The octagon around the disc.
    void disc(const Vector3d& centre, const Vector3d& axis, double radius, double thickness) const {
        constexpr int corners = 8;
        constexpr double step = 2.0 * std::numbers::pi / corners;
        const Vector3d u = axis.unitOrthogonal();
        const Vector3d v = axis.cross(u).normalized();
        for (int n = 0; n < corners; ++n) {
            const Vector3d out = std::cos(n * step) * u + std::sin(n * step) * v;
            bounds.include(centre + radius / std::cos(0.5 * step) * out, thickness);
        }
    }
};

/// The bounds seen along the axes of the picture, and the tangents of the sides of `safe` seen from the eye.
struct View {
    const Bounds& bounds;
    CameraAxes axes;
    double left, right, down, up;  ///< tangents; left and down positive to the left and downwards

    /// Largest value of x right + y up + z forward within the bounds.
    double extent(double x, double y, double z) const {
        return bounds.extent(x * axes.right + y * axes.up + z * axes.forward);
    }
};

View view_of(const Bounds& bounds, const Rect& viewport, const Rect& safe, const Framing& framing) {
    Camera camera;
    camera.eye = Vector3d::Zero();
    camera.target = framing.direction;
    camera.up = framing.up;
    const double per_pixel = 2.0 * std::tan(0.5 * framing.field_of_view) / viewport.height;
    const double centre_x = viewport.x + 0.5 * viewport.width;
    const double centre_y = viewport.y + 0.5 * viewport.height;
    return {
        .bounds = bounds,
        .axes = axes_of(camera),
        .left = (centre_x - safe.x) * per_pixel,
        .right = (safe.x + safe.width - centre_x) * per_pixel,
        .down = (safe.y + safe.height - centre_y) * per_pixel,
        .up = (centre_y - safe.y) * per_pixel,
    };
}

/// The pinhole camera: every point lies on the inner side of four planes through the eye. In the picture's
/// axes, the right plane is  x - right z <= eye_x - right eye_z  and so on: a pair of opposite planes bounds
/// eye_z from above. The smaller bound counts, and then the eye is centred between both planes.
Vector3d pinhole_eye(const View& view) {
    const double right = view.extent(1.0, 0.0, -view.right);
    const double left = view.extent(-1.0, 0.0, -view.left);
    const double up = view.extent(0.0, 1.0, -view.up);
    const double down = view.extent(0.0, -1.0, -view.down);
    const double nearest = -view.extent(0.0, 0.0, -1.0);
    const double depth = view.extent(0.0, 0.0, 1.0) - nearest;
    const double z = std::min({
        -(right + left) / (view.right + view.left),
        -(up + down) / (view.up + view.down),
        nearest - kClearance * depth,
    });
    const double x = 0.5 * ((right + view.right * z) - (left + view.left * z));
    const double y = 0.5 * ((up + view.up * z) - (down + view.down * z));
    return {x, y, z};
}

/// Parallel rays: the distance only sets the scale of the picture.
Vector3d parallel_eye(const View& view, double centre_depth) {
    const double right = view.extent(1.0, 0.0, 0.0);
    const double left = view.extent(-1.0, 0.0, 0.0);
    const double up = view.extent(0.0, 1.0, 0.0);
    const double down = view.extent(0.0, -1.0, 0.0);
    const double distance =
        std::max((right + left) / (view.right + view.left), (up + down) / (view.up + view.down));
    const double x = 0.5 * ((right - view.right * distance) - (left - view.left * distance));
    const double y = 0.5 * ((up - view.up * distance) - (down - view.down * distance));
    return {x, y, centre_depth - distance};
}

void check(const Rect& viewport, const Rect& safe, const Framing& framing) {
    if (safe.width <= 0.0 || safe.height <= 0.0 || viewport.width <= 0.0 || viewport.height <= 0.0) {
        throw std::invalid_argument("frame_scene: nothing can be framed in an empty rectangle");
    }
    // 1e-6 rad: if the view is nearer to `up`, the vertical in the picture is not defined
    if (framing.direction.cross(framing.up).norm() <= 1e-6 * framing.direction.norm() * framing.up.norm()) {
        throw std::invalid_argument("frame_scene: direction must not be zero or along up");
    }
}

/// The largest of 1, 2 or 5 times a power of ten that is not above `size`.
double round_number_below(double size) {
    const double power = std::pow(10.0, std::floor(std::log10(size)));
    for (const double digit : {5.0, 2.0}) {
        if (digit * power <= size) { return digit * power; }
    }
    return power;
}

}  // namespace

void Bounds::include(const Vector3d& centre, double radius) {
    balls_.push_back({centre, radius});
    lowest_ = lowest_.cwiseMin(centre - Vector3d::Constant(radius));
    highest_ = highest_.cwiseMax(centre + Vector3d::Constant(radius));
}

void Bounds::include(const Bounds& other) {
    balls_.insert(balls_.end(), other.balls_.begin(), other.balls_.end());
    lowest_ = lowest_.cwiseMin(other.lowest_);
    highest_ = highest_.cwiseMax(other.highest_);
}

double Bounds::extent(const Vector3d& direction) const {
    if (empty()) { throw std::logic_error("Bounds::extent: nothing was included"); }
    const double length = direction.norm();
    double most = -std::numeric_limits<double>::infinity();
    for (const Ball& ball : balls_) {
        most = std::max(most, direction.dot(ball.centre) + length * ball.radius);
    }
    return most;
}

Bounds bounds_of_shapes(const std::vector<Shape>& shapes) {
    Bounds bounds;
    for (const Shape& shape : shapes) { std::visit(Include{bounds}, shape.geometry); }
    return bounds;
}

Bounds bounds_of(const Scene& scene) {
    Bounds bounds = bounds_of_shapes(scene.shapes);
    for (const Arrow& arrow : scene.arrows) {
        bounds.include(arrow.from, arrow.radius);
        bounds.include(arrow.to, arrow.radius);
    }
    for (const Triad& triad : scene.triads) {
        bounds.include(triad.pose.r);
        for (int axis = 0; axis < 3; ++axis) {
            bounds.include(triad.pose.r + triad.length * triad.pose.A.col(axis));
        }
    }
    for (const Polyline& line : scene.polylines) {
        for (const Vector3d& point : line.points) { bounds.include(point); }
    }
    return bounds;
}

Rect seen_part(const Bounds& bounds, const Camera& camera, const Rect& viewport) {
    if (bounds.empty()) { return {viewport.x, viewport.y, 0.0, 0.0}; }
    const CameraAxes axes = axes_of(camera);
    const double focal = 0.5 * viewport.height / std::tan(0.5 * camera.field_of_view);
    Eigen::AlignedBox2d seen;
    for (const Bounds::Ball& ball : bounds.balls()) {
        const Vector3d from_eye = ball.centre - camera.eye;
        const double depth = from_eye.dot(axes.forward);
        if (!camera.orthographic && depth - ball.radius < kNearest * camera.distance()) { return viewport; }
        const double reach = camera.orthographic ? 0.0 : ball.radius;
        const Eigen::Vector2d at(from_eye.dot(axes.right), -from_eye.dot(axes.up));
        // corners of the box around the ball, at its nearest and its farthest depth
        for (const double side : {-ball.radius, ball.radius}) {
            for (const double nearer : {-reach, reach}) {
                const double scale = focal / ((camera.orthographic ? camera.distance() : depth) - nearer);
                seen.extend(scale * (at + Eigen::Vector2d::Constant(side)));
            }
        }
    }
    const Eigen::Vector2d centre(viewport.x + 0.5 * viewport.width, viewport.y + 0.5 * viewport.height);
    const Eigen::Vector2d low = (centre + seen.min()).array().floor() - 1.0;
    const Eigen::Vector2d high = (centre + seen.max()).array().ceil() + 1.0;
    return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

Camera frame_scene(const Bounds& bounds, const Rect& viewport, const Rect& safe, const Framing& framing) {
    check(viewport, safe, framing);
    Bounds shown = bounds;
    if (shown.empty()) { shown.include(Vector3d::Zero(), 0.5); }
    if (shown.diagonal() < kPoint) { shown.include(shown.centre(), kPointSize); }

    const View view = view_of(shown, viewport, safe, framing);
    const double centre_depth = shown.centre().dot(view.axes.forward);
    const Vector3d eye = framing.orthographic ? parallel_eye(view, centre_depth) : pinhole_eye(view);

    Camera camera;
    camera.eye = view.axes.right * eye.x() + view.axes.up * eye.y() + view.axes.forward * eye.z();
    camera.target = camera.eye + view.axes.forward * (centre_depth - eye.z());
    camera.up = framing.up;
    camera.field_of_view = framing.field_of_view;
    camera.orthographic = framing.orthographic;
    return camera;
}

Camera frame_scene(const Bounds& bounds, const Rect& viewport, const Framing& framing) {
    return frame_scene(
        bounds, viewport, shrunk(viewport, 0.08 * std::min(viewport.width, viewport.height)), framing);
}

Ground ground_below(const Bounds& bounds, const Vector3d& normal) {
    const double diagonal = bounds.diagonal() < kPoint ? kPointSize : bounds.diagonal();
    const Vector3d up = normal.normalized();
    const Vector3d centre = bounds.empty() ? Vector3d::Zero() : bounds.centre();
    const double lowest = bounds.empty() ? 0.0 : -bounds.extent(-up);
    Ground ground;
    // a gap prevents the edges of bodies that lie flat from mixing with the plane
    ground.point = centre + (lowest - 0.002 * diagonal - up.dot(centre)) * up;
    ground.normal = up;
    ground.grid = round_number_below(diagonal / 5.0);
    ground.radius = 1.6 * diagonal;
    return ground;
}

}  // namespace jw::render
