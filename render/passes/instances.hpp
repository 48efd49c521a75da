#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "render/scene/framing.hpp"
#include "render/scene/scene.hpp"
#include "render/scene/shapes.hpp"

/// Turns a scene into copies of a few meshes, which the graphics card draws. No GL.
namespace jw::render {

/// One copy of a mesh, in the layout that the vertex shader reads.
struct Instance {
    Eigen::Matrix<float, 3, 4, Eigen::RowMajor> pose;  ///< mesh frame to global frame
    Eigen::Vector4f size = Eigen::Vector4f::Ones();    ///< of the core: x, y, z, and the inner radius
    float rounding = 0.0F;
    float edge_width = 0.0F;  ///< of the outline, in pixels of a picture 720 high
    float id = 0.0F;          ///< exact: below 2^24
    float padding = 0.0F;
    Colour colour;
    Colour edge_colour;

    bool operator==(const Instance&) const = default;
};
static_assert(sizeof(Instance) == 28 * sizeof(float), "attribute pointers assume no gaps");

/// Instances of each mesh, by `mesh_number`.
using InstanceLists = std::array<std::vector<Instance>, kMeshes>;

/// A straight piece of a line, drawn with a constant width in the picture.
struct LineSegment {
    Eigen::Vector3f from;
    Eigen::Vector3f to;
    float width = 1.0F;  ///< pixels of a picture 720 high
    Colour colour;
    float id = 0.0F;
};
static_assert(sizeof(LineSegment) == 12 * sizeof(float), "attribute pointers assume no gaps");

struct DrawLists {
    InstanceLists bodies;       ///< opaque, cast and receive shadow
    InstanceLists annotations;  ///< opaque: arrows and axes that bodies may hide
    InstanceLists see_through;  ///< opaque, and faint where hidden
    InstanceLists emphasised;   ///< the same, also with their outlines where hidden
    InstanceLists ghosts;       ///< transparent
    std::vector<LineSegment> lines;
    std::vector<LineSegment> see_through_lines;
};

/// Length that covers one pixel at a point [m]; negative behind the eye.
using PixelAt = std::function<double(const Vector3d& point)>;

/// @param dash_length  of dashed lines and arrows [m], > 0; gaps are 0.7 of it
/// @param tone  of vectors, axes, lines, outlines and of what is visible through bodies; bodies keep their
/// colours
/// @param pixel_at  decides the detail of each shape; none: all have the highest detail
DrawLists draw_lists_of(
    const Scene& scene, double dash_length, Tone tone = Tone::light, const PixelAt& pixel_at = {});

/// Bounds of everything in the lists, slightly too large: the box around each instance.
Bounds bounds_of(const DrawLists& lists);

/// Pixels, in a picture 720 high, by which outlines and lines reach beyond `bounds_of` at most.
float border_of(const DrawLists& lists);

}  // namespace jw::render
