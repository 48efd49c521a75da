#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "core/numerics/linear.hpp"
#include "render/scene/camera.hpp"

/// Sphere of all directions of the axis s_i. The colour is the smaller singular value of the two rows of p1
/// or p2 in use: it shows which pair is good for which direction.
///
/// If s_i is a unit vector and everything is assembled, the rows that remain when component k is left out
/// have the singular values 1 and |s_k| (core/equations/independent_rows.hpp).
namespace jw::panels {

enum class PairInUse { rule, drop_x, drop_y, drop_z };

struct DirectionSphere {
    PairInUse pair = PairInUse::rule;
    std::optional<Vec3> axis;  ///< current direction of s_i, global, unit
    int dropped = -1;          ///< component that the rule leaves out (may be an earlier choice); -1: largest
    std::vector<Vec3> trail;   ///< earlier directions of s_i, oldest first, unit
};

/// Smallest singular value of the pair in use for the direction `s_i`, unit: 0 to 1.
double pair_quality(PairInUse pair, const Vec3& s_i);

/// The sphere in a parallel projection along the camera's view.
struct SphereView {
    Point centre;
    float radius = 1.0F;
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitZ();
    Vec3 towards = -Vec3::UnitY();  ///< to the eye

    /// Pixel of the point at `size` radii in the direction `d`.
    Point pixel(const Vec3& d, double size = 1.0) const;
    bool faces(const Vec3& d) const { return d.dot(towards) >= 0.0; }
    /// The direction under a pixel, on the visible side; beyond the rim, the nearest direction on the rim.
    /// Empty if the pixel is farther than half a radius from the sphere.
    std::optional<Vec3> direction(Point pixel) const;
};

/// Draws the sphere, its scale, and the sentences about the current axis.
/// @param camera of the 3D picture, so that the sphere turns with it
/// @return the view, to handle the mouse
SphereView direction_sphere(
    const Canvas& canvas, const Box& box, const DirectionSphere& sphere, const render::CameraAxes& camera);

/// The sentences below the sphere.
std::string sphere_words(const DirectionSphere& sphere);

/// Lines on the surface: contours, borders, the circle where rank is lost.
struct SphereLine {
    std::vector<Vec3> points;  ///< unit, closed if first and last are equal
    std::string label;         ///< empty: none
    enum class Kind { contour, border, lost } kind = Kind::contour;
};
std::vector<SphereLine> lines_of(PairInUse pair);

/// Colour of a quality between 0 and 1: vermilion below, paper at 1/√3, blue above.
Colour colour_of_quality(double quality);

/// Draws the disc: every direction in the colour of its quality, a little darker towards the rim.
void draw_shading(const Canvas& canvas, const SphereView& view, PairInUse pair);

/// The parts of a line that face the eye, as runs of pixels.
std::vector<std::vector<Point>> front_of(const SphereView& view, const std::vector<Vec3>& points);

}  // namespace jw::panels
