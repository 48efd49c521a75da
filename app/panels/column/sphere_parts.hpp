#pragma once

#include "app/panels/column/direction_sphere.hpp"

/// Parts shared by the files of the sphere.
namespace jw::panels {

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
