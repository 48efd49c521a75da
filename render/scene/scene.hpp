#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "render/scene/palette.hpp"

/// Scene to be drawn, as plain values: no mechanism, no GL, no window. Lengths in m, global frame.
///
/// An `id` names what the pointer hits (see `IdBuffer`): 1 to `kMostIds`; several parts may share one. With
/// id 0, the pointer ignores the part.
namespace jw::render {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline constexpr int kMostIds = (1 << 24) - 1;

/// A body frame: columns of A are its axes, r its origin.
struct Pose {
    Matrix3d A = Matrix3d::Identity();
    Vector3d r = Vector3d::Zero();
};

/// A box whose edges the renderer rounds.
struct Box {
    Pose pose;
    Vector3d half_size = Vector3d::Constant(0.5);
};

struct Sphere {
    Vector3d centre = Vector3d::Zero();
    double radius = 0.5;
};

/// Round bar with flat ends; a short one is a disc.
struct Cylinder {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    double radius = 0.1;
};

/// Round bar with hemispherical ends centred at `from` and `to`.
struct Rod {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    double radius = 0.1;
};

/// Hollow cylinder: sleeve of a cylindrical joint, eye of a hinge, washer.
struct Tube {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    double outer_radius = 0.15;
    double inner_radius = 0.1;
};

/// Torus about `axis`.
struct Ring {
    Vector3d centre = Vector3d::Zero();
    Vector3d axis = Vector3d::UnitZ();
    double radius = 0.2;        ///< of the centre line
    double wire_radius = 0.02;  ///< of the wire
};

/// Threaded bolt. The thread is right-handed for pitch > 0. It starts at `from` in the direction `side`, so
/// it turns with the body if `side` is fixed in the body.
struct Screw {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    Vector3d side = Vector3d::UnitX();
    double radius = 0.1;  ///< of the crests
    double pitch = 0.05;  ///< m per turn
};

/// Hexagonal nut with a round hole; a corner points to `side`.
struct Nut {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    Vector3d side = Vector3d::UnitX();
    double corner_radius = 0.2;
    double hole_radius = 0.1;
};

using Geometry = std::variant<Box, Sphere, Cylinder, Rod, Tube, Ring, Screw, Nut>;

struct Shape {
    Geometry geometry;
    Colour colour = palette::kSteel;  ///< alpha < 1: a ghost, drawn last and without shadow
    bool highlighted = false;         ///< outlined in the ink colour; see-through shapes also have a halo
    bool see_through = false;         ///< faintly visible through what hides it: points and pins in bodies
    int id = 0;
};

/// A vector: shaft and cone, tip at `to`. A zero vector is not drawn.
struct Arrow {
    Vector3d from = Vector3d::Zero();
    Vector3d to = Vector3d::UnitZ();
    double radius = 0.01;  ///< of the shaft; for a constant width in the picture, see `pixel_size`
    Colour colour = palette::kVectorI;
    bool dashed = false;
    bool see_through = true;
    int id = 0;
    bool highlighted =
        false;  ///< thicker, with a halo that is also visible through bodies if the arrow is see-through
};

/// Axes of a frame: x, y, z in the colours of `palette::kAxes`.
struct Triad {
    Pose pose;
    double length = 0.2;
    double radius = 0.006;
    float alpha = 1.0F;
    bool see_through = true;
    int id = 0;
};

/// Path of a point, distance line, axis. Always faces the camera.
struct Polyline {
    std::vector<Vector3d> points;
    double width = 2.0;  ///< pixels of a picture 720 high; grows with the picture
    Colour colour = palette::kInkSoft;
    bool dashed = false;
    bool closed = false;
    bool see_through = true;
    int id = 0;
};

/// A plane with a fine grid that fades out, and the soft shadow of everything above it.
struct Ground {
    Vector3d point = Vector3d::Zero();
    Vector3d normal = Vector3d::UnitZ();
    double grid = 0.5;    ///< distance of the lines
    double radius = 5.0;  ///< distance at which it has faded out entirely

    bool operator==(const Ground&) const = default;
};

struct Scene {
    std::vector<Shape> shapes;
    std::vector<Arrow> arrows;
    std::vector<Triad> triads;
    std::vector<Polyline> polylines;
    std::optional<Ground> ground;
};

}  // namespace jw::render
