#include "render/scene/camera.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

// Depth range in distances from eye to target: a scene composed by `frame_scene` never comes nearer than
// 0.2, the ground plane fades out long before 60, and 24 bits of depth resolve 1e-5 between them.
constexpr double kNear = 0.05;
constexpr double kFar = 60.0;

}  // namespace

Rect shrunk(const Rect& rect, double pixels) {
    return {rect.x + pixels, rect.y + pixels, rect.width - 2.0 * pixels, rect.height - 2.0 * pixels};
}

CameraAxes axes_of(const Camera& camera) {
    const Vector3d forward = (camera.target - camera.eye).normalized();
    const Vector3d right = forward.cross(camera.up).normalized();
    return {right, right.cross(forward), forward};
}

Matrix4d view_matrix(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    Matrix4d view = Matrix4d::Identity();
    view.block<1, 3>(0, 0) = axes.right.transpose();
    view.block<1, 3>(1, 0) = axes.up.transpose();
    view.block<1, 3>(2, 0) = -axes.forward.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * camera.eye;
    return view;
}

Matrix4d projection_matrix(const Camera& camera, double aspect) {
    const double distance = camera.distance();
    const double tangent = std::tan(0.5 * camera.field_of_view);
    const double far = kFar * distance;
    Matrix4d m = Matrix4d::Zero();
    if (camera.orthographic) {
        // parallel rays do not begin at the eye, so the scene may extend behind it
        const double near = -far;
        m(0, 0) = 1.0 / (tangent * distance * aspect);
        m(1, 1) = 1.0 / (tangent * distance);
        m(2, 2) = -2.0 / (far - near);
        m(2, 3) = -(far + near) / (far - near);
        m(3, 3) = 1.0;
    } else {
        const double near = kNear * distance;
        m(0, 0) = 1.0 / (tangent * aspect);
        m(1, 1) = 1.0 / tangent;
        m(2, 2) = -(far + near) / (far - near);
        m(2, 3) = -2.0 * far * near / (far - near);
        m(3, 2) = -1.0;
    }
    return m;
}

Projected project(const Camera& camera, const Rect& viewport, const Vector3d& point) {
    const CameraAxes axes = axes_of(camera);
    const Vector3d from_eye = point - camera.eye;
    const double depth = from_eye.dot(axes.forward);
    const double scale_at = camera.orthographic ? camera.distance() : depth;
    const double focal = 0.5 * viewport.height / (std::tan(0.5 * camera.field_of_view) * scale_at);

    Projected seen;
    seen.x = viewport.x + 0.5 * viewport.width + focal * from_eye.dot(axes.right);
    seen.y = viewport.y + 0.5 * viewport.height - focal * from_eye.dot(axes.up);
    seen.depth = depth;
    const bool in_front = camera.orthographic || depth > kNear * camera.distance();
    seen.visible = in_front && viewport.contains(seen.x, seen.y);
    return seen;
}

double pixel_size(const Camera& camera, const Rect& viewport, const Vector3d& point) {
    const double depth = (point - camera.eye).dot(axes_of(camera).forward);
    const double scale_at = camera.orthographic ? camera.distance() : depth;
    return 2.0 * std::tan(0.5 * camera.field_of_view) * scale_at / viewport.height;
}

}  // namespace jw::render
