#pragma once

#include <vector>

#include <Eigen/Core>

#include "render/scene/camera.hpp"
#include "render/scene/scene.hpp"

/// Places the camera so that everything is in view and nothing is cut off, without any number chosen by hand.
namespace jw::render {

/// Bounds of what must be in view: spheres and points. Unlike a box, they are tight from every direction. The
/// bounds of many poses, included one after the other, frame the whole motion of a scene.
class Bounds {
public:
    void include(const Vector3d& centre, double radius = 0.0);
    void include(const Bounds& other);

    bool empty() const { return balls_.empty(); }

    // corners of the axis-aligned box around it; meaningless when empty
    const Vector3d& lowest() const { return lowest_; }
    const Vector3d& highest() const { return highest_; }
    Vector3d centre() const { return 0.5 * (lowest_ + highest_); }
    double diagonal() const { return empty() ? 0.0 : (highest_ - lowest_).norm(); }

    /// Largest value of direction.dot(point) within.
    /// @throws std::logic_error when empty
    double extent(const Vector3d& direction) const;

    struct Ball {
        Vector3d centre;
        double radius;
    };
    /// The spheres and points from which `extent` is computed.
    const std::vector<Ball>& balls() const { return balls_; }

private:
    std::vector<Ball> balls_;
    Vector3d lowest_ = Vector3d::Constant(1e300);
    Vector3d highest_ = Vector3d::Constant(-1e300);
};

/// Bounds of everything in the scene but the ground plane.
Bounds bounds_of(const Scene& scene);
Bounds bounds_of_shapes(const std::vector<Shape>& shapes);

/// Part of the picture that covers everything within the bounds, in whole pixels; it may extend beyond the
/// viewport. It is the whole viewport if the bounds reach the eye. Empty bounds cover nothing.
Rect seen_part(const Bounds& bounds, const Camera& camera, const Rect& viewport);

struct Framing {
    /// Direction from the eye to the scene; need not be unit.
    Vector3d direction = {-0.55, 0.75, -0.45};
    Vector3d up = Vector3d::UnitZ();
    double field_of_view = 0.5;
    bool orthographic = false;
};

/// The nearest camera of that direction with all of `bounds` inside `safe`, a part of the `viewport` that the
/// scene is drawn into: leave a margin there for captions and labels.
///
/// Empty bounds count as a cube of 1 m at the origin, a point as a sphere of 1 cm.
/// @throws std::invalid_argument if `safe` is empty or `direction` is zero or along `up`.
Camera frame_scene(const Bounds& bounds, const Rect& viewport, const Rect& safe, const Framing& framing = {});

/// Frames a scene with a margin of 8 % of the smaller side all around.
Camera frame_scene(const Bounds& bounds, const Rect& viewport, const Framing& framing = {});

/// A ground plane under the scene, of suitable size: just below its lowest point along `normal`, with a grid
/// of 1, 2 or 5 times a power of ten, fading out around it.
Ground ground_below(const Bounds& bounds, const Vector3d& normal = Vector3d::UnitZ());

}  // namespace jw::render
