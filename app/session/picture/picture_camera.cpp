#include "app/session/picture/picture.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "app/session/picture/picture_parts.hpp"
#include "core/elementary/elementary.hpp"
#include "core/jets/euler_parameters.hpp"

namespace jw {

namespace {

// cosine above which axes count as parallel
constexpr double kParallel = 0.996;
// sine of the angle between view and axis at which a vector along the axis becomes long enough in the picture
constexpr double kNotEndOn = 0.45;

/// Axes of the joints that have one, at the last pose before the motion; unit.
struct Axes {
    std::vector<Vec3> turning;
    std::vector<Vec3> all;
    bool planar = true;  ///< every joint keeps its two axes parallel
};

Axes axes_of(const Story& story) {
    const State& state = story.steps()[at(story.last_assembled())].state;
    const auto direction = [&](int body, const Vec3& s_local) {
        return Vec3(rotation_matrix(state.p[at(body)].normalized()) * s_local.normalized());
    };
    Axes axes;
    for (const Joint& joint : story.lesson().mechanism.joints) {
        const bool crossed = joint.type->uses(Role::axes_perpendicular);
        axes.planar = axes.planar && joint.type->uses(Role::axes_parallel);
        if (!picture::contains(joint, kAxisI, {FormulaVector::s_i})) { continue; }
        axes.all.push_back(direction(joint.body_i, joint.geometry.s_i_local));
        if (crossed) { axes.all.push_back(direction(joint.body_j, joint.geometry.s_j_local)); }
        // a joint that slides along its axis is seen best from the side
        if (!joint.type->uses(Role::distance_parallel)) { axes.turning.push_back(axes.all.back()); }
    }
    return axes;
}

/// The common direction of all axes of rotation, zero if there is none.
Vec3 common_axis(const Axes& axes) {
    if (!axes.planar || axes.turning.size() < 2) { return Vec3::Zero(); }
    const Vec3& first = axes.turning.front();
    const bool common = std::ranges::all_of(
        axes.turning, [&](const Vec3& axis) { return std::abs(axis.dot(first)) > kParallel; });
    return common ? first : Vec3(Vec3::Zero());
}

/// View direction mostly along the axis, but tilted so that depth shows; x (or else y) goes to the right.
Vec3 across_the_plane(const Vec3& axis, const Vec3& up) {
    if (std::abs(axis.dot(up)) > kParallel) {
        // a mechanism that lies flat is looked at from above and in front
        const Vec3 front = std::abs(up.y()) < 0.9 ? Vec3(Vec3::UnitY()) : Vec3(-Vec3::UnitZ());
        return (-0.78 * up + 0.62 * front).normalized() - 0.2 * front.cross(up);
    }
    Vec3 forward = axis;
    const Vec3 right = forward.cross(up).normalized();
    if (right.x() + 0.5 * right.y() < 0.0) { forward = -forward; }
    const Vec3 side = forward.cross(up).normalized();
    return forward - 0.44 * side - 0.32 * up;
}

/// Direction of the three-quarter view: from the right, in front and above.
Vec3 three_quarter(const Vec3& up) {
    const Vec3 across = std::abs(up.x()) < 0.9 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 right = (across - across.dot(up) * up).normalized();
    return -0.62 * right + 0.66 * up.cross(right) - 0.42 * up;
}

/// Sine of the smallest angle between the view and an axis.
double shortest(const std::vector<Vec3>& axes, const Vec3& view) {
    double least = 1.0;
    for (const Vec3& axis : axes) { least = std::min(least, axis.cross(view).norm()); }
    return least;
}

/// `view`, turned about `up` just enough that no axis is seen end-on.
Vec3 turned_off_axes(const Vec3& view, const Vec3& up, const std::vector<Vec3>& axes) {
    constexpr double step = 0.2;    // rad
    constexpr int most = 5;         // steps to either side
    constexpr double price = 0.01;  // of a step, so that the nearest of equally good views is taken
    Vec3 best = view.normalized();
    double best_value = -1.0;
    for (int k = -most; k <= most; ++k) {
        const Vec3 turned = rotation_matrix(euler_parameters_of(up, step * k)) * view.normalized();
        const double value = std::min(shortest(axes, turned), kNotEndOn) - price * std::abs(k);
        if (value > best_value) {
            best_value = value;
            best = turned;
        }
    }
    return best;
}

/// Smallest distance from a given target at which all of `bounds` is inside `safe`.
double distance_to_fit(
    const render::Bounds& bounds, const render::Camera& camera, const render::Rect& viewport,
    const render::Rect& safe) {
    const render::CameraAxes axes = render::axes_of(camera);
    const double per_pixel = 2.0 * elementary::tan(0.5 * camera.field_of_view) / viewport.height;
    const double centre_x = viewport.x + 0.5 * viewport.width;
    const double centre_y = viewport.y + 0.5 * viewport.height;
    double distance = 0.0;
    const auto keep_inside = [&](const Vec3& outwards, double pixels) {
        const double tangent = std::max(1.0, pixels) * per_pixel;
        const Vec3 normal = camera.orthographic ? outwards : Vec3(outwards - tangent * axes.forward);
        distance = std::max(distance, (bounds.extent(normal) - normal.dot(camera.target)) / tangent);
    };
    keep_inside(axes.right, safe.x + safe.width - centre_x);
    keep_inside(-axes.right, centre_x - safe.x);
    keep_inside(axes.up, centre_y - safe.y);
    keep_inside(-axes.up, safe.y + safe.height - centre_y);
    return distance;
}

}  // namespace

Vec3 view_direction(const Story& story, const Vec3& up) {
    const CameraWish& wish = story.lesson().camera;
    if (wish.from) { return -wish.from->normalized(); }
    const Axes axes = axes_of(story);
    const Vec3 common = common_axis(axes);
    if (!common.isZero()) { return across_the_plane(common, up).normalized(); }
    return turned_off_axes(three_quarter(up), up, axes.all);
}

render::Camera camera_of(
    const Story& story, const PictureStyle& style, const render::Rect& viewport, const render::Rect& safe) {
    const CameraWish& wish = story.lesson().camera;
    render::Framing framing;
    framing.up = style.up;
    framing.direction = style.view;
    framing.orthographic = wish.orthographic;
    // if up is almost along the view, it does not determine how the picture is turned
    if (framing.direction.cross(framing.up).norm() < 1e-3) {
        framing.up = perpendicular_to(framing.direction);
    }
    render::Camera camera = render::frame_scene(style.bounds, viewport, safe, framing);
    double distance = camera.distance();
    if (wish.target) {
        camera.target = *wish.target;
        camera.eye = camera.target - distance * style.view;
        distance = distance_to_fit(style.bounds, camera, viewport, safe);
    }
    camera.eye = camera.target - wish.distance.value_or(distance) * style.view;
    return camera;
}

}  // namespace jw
