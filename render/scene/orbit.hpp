#pragma once

#include "render/scene/camera.hpp"

/// Moves a camera by hand, and finds what the pointer points at. Pixels are those of `project`: y down.
///
/// Cameras turn about their target as on a turntable: `up` stays, and the eye stays at least 1e-3 rad
/// away from the poles. There, the picture still has a definite heading, and straight lines do not look
/// tilted.
namespace jw::render {

/// The camera turned so that the scene seems to follow the pointer: `dx_rad` to the right about `up`,
/// `dy_rad` down.
Camera orbited(const Camera& camera, double dx_rad, double dy_rad);

/// The camera shifted so that the point at the target moves by (dx_px, dy_px) in the picture.
Camera panned(const Camera& camera, const Rect& viewport, double dx_px, double dy_px);

/// The picture magnified by `factor` > 0 about the point seen at (x, y) in the depth of the target.
/// @param scene_size  [m] the distance stays within 0.01 to 10 of it, so that nobody loses the scene; a
/// camera that is already outside does not go further
Camera zoomed(
    const Camera& camera, const Rect& viewport, double factor, double x, double y, double scene_size);

enum class StandardView { front, back, left, right, top, bottom, isometric };

/// The horizontal axis that the fronts of scenes face along: x of the global frame, or y if `up` is along x;
/// made perpendicular to `up`. Unit.
Vector3d level_axis(const Vector3d& up);

/// View from another side, around the same target at the same distance. With up = z, front looks along y with
/// x to the right, `right` looks along −x, and top shows x to the right and y up; with up = y, front looks
/// along −z.
Camera standard_view(const Camera& camera, StandardView view);

/// Camera between two others, moving around the target, not through it. Fraction 0 gives `from` and 1
/// gives `to`, exactly.
Camera blended(const Camera& from, const Camera& to, double fraction);

/// Point where the ray through (x, y) meets the plane through `through` that is parallel to the picture: a
/// point grabbed at `through` and dragged to (x, y) moves there. `through` must be in front of the eye.
Vector3d point_at_depth(
    const Camera& camera, const Rect& viewport, double x, double y, const Vector3d& through);

}  // namespace jw::render
