#pragma once

#include <Eigen/Core>

/// Camera of a picture, and where a point appears in the picture. No GL.
namespace jw::render {

using Eigen::Matrix4d;
using Eigen::Vector3d;

/// Rectangle of the frame in pixels; origin at the top left corner, y down, as in ImGui.
struct Rect {
    double x = 0.0;
    double y = 0.0;
    double width = 1280.0;
    double height = 720.0;

    bool operator==(const Rect&) const = default;

    bool contains(double px, double py) const {
        return px >= x && px <= x + width && py >= y && py <= y + height;
    }
};

/// `rect` reduced by `pixels` on each side.
Rect shrunk(const Rect& rect, double pixels);

/// A pinhole or parallel camera. `eye` and `target` must differ and `up` must not be along the view.
struct Camera {
    Vector3d eye = {3.0, -4.0, 2.5};
    Vector3d target = Vector3d::Zero();
    Vector3d up = Vector3d::UnitZ();
    double field_of_view = 0.5;  ///< vertical [rad]
    bool orthographic = false;   ///< the picture at the target is as high as that of a pinhole camera

    bool operator==(const Camera&) const = default;

    double distance() const { return (target - eye).norm(); }
};

/// Axes of the picture in the global frame: right, up, forward (unit, right x up = -forward).
struct CameraAxes {
    Vector3d right;
    Vector3d up;
    Vector3d forward;
};

CameraAxes axes_of(const Camera& camera);

/// Global frame to camera frame (x right, y up, z towards the viewer).
Matrix4d view_matrix(const Camera& camera);

/// Camera frame to clip space of GL, for a picture with aspect = width / height.
Matrix4d projection_matrix(const Camera& camera, double aspect);

/// Place at which a point is seen.
struct Projected {
    double x = 0.0;      ///< pixels from the left edge of the frame
    double y = 0.0;      ///< pixels from the top edge of the frame
    double depth = 0.0;  ///< distance from the eye along the view [m]
    bool visible =
        false;  ///< in front of the camera and within the viewport (it may still be hidden by a body)
};

/// The pixel at which `point` is drawn if the scene is drawn into `viewport`.
Projected project(const Camera& camera, const Rect& viewport, const Vector3d& point);

/// Length in m that covers one pixel at `point`: for arrows and points of constant width in the picture.
double pixel_size(const Camera& camera, const Rect& viewport, const Vector3d& point);

/// Size of the frame that is drawn into. `pixel_ratio` device pixels stand for one pixel of the picture:
/// usually 1, but 2 if a driver without multisampling requires drawing at double size.
struct FrameSize {
    int width = 0;  ///< pixels of the picture
    int height = 0;
    int pixel_ratio = 1;

    bool operator==(const FrameSize&) const = default;
};

/// Part of a frame that is drawn into buffers of its own size: usually all of it; one of several tiles if the
/// frame is larger than the buffers can be. Pixels of the picture, from its upper left corner.
struct FramePart {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const FramePart&) const = default;
};

}  // namespace jw::render
