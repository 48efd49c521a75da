#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

/// Meshes of the renderer, made once and drawn many times.
///
/// A vertex is a core point plus a direction: an instance of the mesh puts it at
///
///   core * size + normal * rounding
///
/// so one mesh gives boxes of every size with edges of the same radius, and bars of every length with
/// hemispherical ends; the normals stay smooth and correct. The axis of round shapes is z, from 0 to 1.
namespace jw::render {

enum class MeshKind : std::uint8_t {
    box,           ///< corners at ±1
    round_bar,     ///< flat or hemispherical ends: core a cylinder of radius 1
    rod,           ///< core a line: a capsule, and a sphere when size is 0
    tube,          ///< outer and inner radius
    ring,          ///< core a circle of radius 1 in the plane z = 0
    nut,           ///< hexagon with corners at radius 1, first one on x; round hole
    right_thread,  ///< one turn of a ridge; z counts turns
    left_thread,
    shaft,  ///< of an arrow, like `round_bar` with sharp ends
    cone,   ///< arrow head of radius 1 and length `kConeLength`; scale it uniformly
};

inline constexpr std::size_t kMeshKinds = 10;
inline constexpr float kConeLength = 2.7F;

/// Fineness of a mesh. A software renderer needs time for every vertex in every pass and, for every triangle,
/// for each whole block of pixels that it touches: triangles thinner than a pixel take more time than all the
/// rest.
enum class Detail : std::uint8_t { coarse, low, medium, high };

inline constexpr std::size_t kDetails = 4;

/// The lowest detail with which no corner is visible.
/// @param radius  of the shape in the picture [pixels]; NaN and values < 0 (behind the eye): `high`
Detail detail_for(double radius);

struct MeshVertex {
    Eigen::Vector4f core;    ///< w = 1: x and y scale with the inner radius instead of the outer
    Eigen::Vector3f normal;  ///< unit, outwards
};

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint16_t> indices;  ///< triangles, counter-clockwise seen from outside
};

Mesh make_mesh(MeshKind kind, Detail detail = Detail::high);

/// Number of a mesh among all, below `kMeshes`.
constexpr std::size_t mesh_number(MeshKind kind, Detail detail) {
    return static_cast<std::size_t>(kind) * kDetails + static_cast<std::size_t>(detail);
}
inline constexpr std::size_t kMeshes = kMeshKinds * kDetails;

/// The mesh of that number.
Mesh make_mesh(std::size_t number);

}  // namespace jw::render
