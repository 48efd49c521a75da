#include "app/session/picture_camera.hpp"

#include <cmath>

namespace jw {

namespace {

// cosine above which axes count as parallel
constexpr double kParallel = 0.996;
const Vec3 kThreeQuarter{-0.62, 0.66, -0.42};

/// The common direction of all joint axes at the last pose before the motion, zero if there is none.
Vec3 common_axis(const Story& story) {
    const Step& step = story.steps()[static_cast<std::size_t>(story.last_assembled())];
    Vec3 common = Vec3::Zero();
    for (const Joint& joint : story.lesson().mechanism.joints) {
        if (!joint.type->uses(Role::axes_parallel)) { return Vec3::Zero(); }
        const Vec4 p = step.state.p[static_cast<std::size_t>(joint.body_i)].normalized();
        const Vec3 axis = rotation_matrix(p) * joint.geometry.s_i_local.normalized();
        if (joint.type->uses(Role::distance_parallel)) {
            continue;
        }  // slides along it: seen best from the side
        if (!common.isZero() && std::abs(common.dot(axis)) < kParallel) { return Vec3::Zero(); }
        if (common.isZero()) { common = axis; }
    }
    return common;
}

/// Mostly along the axis, but tilted so that depth shows; x (or else y) goes to the right.
Vec3 across_the_plane(const Vec3& axis, const Vec3& up) {
    if (std::abs(axis.dot(up)) > kParallel) {
        // a mechanism that lies flat is looked at from above and in front
        const Vec3 front = std::abs(up.y()) < 0.9 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
        return (-0.80 * up + 0.62 * front).normalized() - 0.18 * front.cross(up);
    }
    Vec3 forward = axis;
    const Vec3 right = forward.cross(up).normalized();
    if (right.x() + 0.5 * right.y() < 0.0) { forward = -forward; }
    const Vec3 side = forward.cross(up).normalized();
    return forward - 0.34 * side - 0.26 * up;
}

Vec3 direction_of(const Story& story, const Vec3& up) {
    const CameraWish& wish = story.lesson().camera;
    if (wish.from) { return -*wish.from; }
    const Vec3 axis = common_axis(story);
    if (!axis.isZero() && story.lesson().mechanism.joints.size() > 1) { return across_the_plane(axis, up); }
    return std::abs(kThreeQuarter.normalized().dot(up)) > 0.9 ? Vec3(kThreeQuarter.cross(up)) : kThreeQuarter;
}

}  // namespace

render::Camera camera_of(
    const Story& story, const PictureStyle& style, const render::Rect& viewport, const render::Rect& safe) {
    const CameraWish& wish = story.lesson().camera;
    render::Framing framing;
    framing.up = style.up;
    framing.direction = direction_of(story, style.up);
    framing.orthographic = wish.orthographic;
    // up as good as along the view leaves the picture's turn open
    if (framing.direction.cross(framing.up).norm() < 1e-3 * framing.direction.norm()) {
        framing.up = perpendicular_to(framing.direction);
    }
    render::Camera camera = render::frame_scene(style.bounds, viewport, safe, framing);
    const Vec3 forward = (camera.target - camera.eye).normalized();
    const double distance = wish.distance.value_or(camera.distance());
    if (wish.target) { camera.target = *wish.target; }
    camera.eye = camera.target - distance * forward;
    return camera;
}

}  // namespace jw
