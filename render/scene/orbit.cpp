#include "render/scene/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

constexpr double kHalfTurn = std::numbers::pi;  // [rad]
// At 1e-3 rad, a line along the view that is as long as the picture is high appears shorter than a pixel.
constexpr double kHighest = 0.5 * kHalfTurn - 1e-3;
constexpr double kNearestInSizes = 0.01;
constexpr double kFarthestInSizes = 10.0;

/// Place of the eye on the sphere around the target.
struct Stand {
    double azimuth = 0.0;    ///< about up, from the level axis
    double elevation = 0.0;  ///< from the horizontal plane, within ±kHighest
    double distance = 1.0;
};

/// The shortest rotation of one unit vector onto another; for opposite vectors, a half turn about some
/// perpendicular axis. Eigen's FromTwoVectors takes that axis from a singular value decomposition, which
/// needs half of the time to compile this source.
Quaterniond turn_between(const Vector3d& from, const Vector3d& to) {
    constexpr double kOpposite = 1e-12;
    const double cosine = to.dot(from);
    if (cosine < kOpposite - 1.0) { return Quaterniond(AngleAxisd(kHalfTurn, from.unitOrthogonal())); }
    const double twice = std::sqrt((1.0 + cosine) * 2.0);
    Quaterniond turn;
    turn.w() = twice * 0.5;
    turn.vec() = from.cross(to) * (1.0 / twice);
    return turn;
}

Stand stand_of(const Vector3d& from_target, const Vector3d& up) {
    const Vector3d ahead = level_axis(up);
    const Vector3d aside = up.cross(ahead);
    const double x = from_target.dot(ahead);
    const double y = from_target.dot(aside);
    const double elevation = std::atan2(from_target.dot(up), std::hypot(x, y));
    return {std::atan2(y, x), std::clamp(elevation, -kHighest, kHighest), from_target.norm()};
}

Vector3d from_target(const Stand& stand, const Vector3d& up) {
    const Vector3d ahead = level_axis(up);
    const Vector3d level = std::cos(stand.azimuth) * ahead + std::sin(stand.azimuth) * up.cross(ahead);
    return stand.distance * (std::cos(stand.elevation) * level + std::sin(stand.elevation) * up);
}

Stand stand_of(const Camera& camera) { return stand_of(camera.eye - camera.target, camera.up.normalized()); }

Camera standing(Camera camera, const Stand& stand) {
    camera.eye = camera.target + from_target(stand, camera.up.normalized());
    return camera;
}

double blend(double from, double to, double fraction) { return from + fraction * (to - from); }

}  // namespace

Camera orbited(const Camera& camera, double dx_rad, double dy_rad) {
    Stand stand = stand_of(camera);
    stand.azimuth -= dx_rad;
    stand.elevation = std::clamp(stand.elevation + dy_rad, -kHighest, kHighest);
    return standing(camera, stand);
}

Camera panned(const Camera& camera, const Rect& viewport, double dx_px, double dy_px) {
    const CameraAxes axes = axes_of(camera);
    const Vector3d shift =
        pixel_size(camera, viewport, camera.target) * (dy_px * axes.up - dx_px * axes.right);
    Camera moved = camera;
    moved.eye += shift;
    moved.target += shift;
    return moved;
}

Camera zoomed(
    const Camera& camera, const Rect& viewport, double factor, double x, double y, double scene_size) {
    const double distance = camera.distance();
    const double wanted = std::clamp(
        distance / factor, std::min(kNearestInSizes * scene_size, distance),
        std::max(kFarthestInSizes * scene_size, distance));
    const Vector3d centre = point_at_depth(camera, viewport, x, y, camera.target);
    Camera moved = camera;
    moved.eye = centre + (camera.eye - centre) * (wanted / distance);
    moved.target = centre + (camera.target - centre) * (wanted / distance);
    return moved;
}

Vector3d level_axis(const Vector3d& up) {
    const Vector3d normal = up.normalized();
    const Vector3d along = std::abs(normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
    return (along - normal * normal.dot(along)).normalized();
}

Camera standard_view(const Camera& camera, StandardView view) {
    // the eye is on the right at azimuth 0, and in front a quarter turn earlier
    Stand stand{-0.5 * kHalfTurn, 0.0, camera.distance()};
    switch (view) {
        case StandardView::front: break;
        case StandardView::back: stand.azimuth = 0.5 * kHalfTurn; break;
        case StandardView::left: stand.azimuth = kHalfTurn; break;
        case StandardView::right: stand.azimuth = 0.0; break;
        case StandardView::top: stand.elevation = kHighest; break;
        case StandardView::bottom: stand.elevation = -kHighest; break;
        case StandardView::isometric:
            stand.azimuth = -0.25 * kHalfTurn;
            stand.elevation = std::atan(std::numbers::sqrt2 / 2.0);  // all three axes equally long
            break;
    }
    return standing(camera, stand);
}

Camera blended(const Camera& from, const Camera& to, double fraction) {
    if (fraction <= 0.0) { return from; }
    if (fraction >= 1.0) { return to; }
    // both stands are compared under the same `up`; the rotation between the two `up` is interpolated as well
    const Vector3d up = from.up.normalized();
    const Quaterniond between = turn_between(up, to.up.normalized());
    const Stand first = stand_of(from);
    const Stand last = stand_of(between.conjugate() * (to.eye - to.target), up);
    Stand stand;
    stand.azimuth = first.azimuth + fraction * std::remainder(last.azimuth - first.azimuth, 2.0 * kHalfTurn);
    stand.elevation = blend(first.elevation, last.elevation, fraction);
    stand.distance = first.distance * std::pow(last.distance / first.distance, fraction);

    const Quaterniond turned = Quaterniond::Identity().slerp(fraction, between);
    Camera camera = from;
    camera.up = turned * up;
    camera.target += fraction * (to.target - from.target);
    camera.eye = camera.target + turned * from_target(stand, up);
    camera.field_of_view = blend(from.field_of_view, to.field_of_view, fraction);
    return camera;
}

Vector3d point_at_depth(
    const Camera& camera, const Rect& viewport, double x, double y, const Vector3d& through) {
    const CameraAxes axes = axes_of(camera);
    const double pixel = pixel_size(camera, viewport, through);
    const double right = x - (viewport.x + 0.5 * viewport.width);
    const double down = y - (viewport.y + 0.5 * viewport.height);
    return camera.eye + (through - camera.eye).dot(axes.forward) * axes.forward +
           pixel * (right * axes.right - down * axes.up);
}

}  // namespace jw::render
