#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Scenes for other programs: binary glTF 2.0 (.glb), for browsers, Blender, slide programs and viewers.
namespace jw::gltf {

/// Triangles of one colour.
struct Mesh {
    std::vector<std::array<float, 3>> positions;  ///< [m]
    std::vector<std::array<float, 3>> normals;    ///< unit, one for each position
    std::vector<std::uint32_t> indices;           ///< three for each triangle, counter-clockwise from outside
    std::array<float, 4> colour{0.5F, 0.5F, 0.5F, 1.0F};  ///< sRGB and alpha, 0 to 1
};

/// Pose of a node.
struct Pose {
    std::array<float, 3> translation{};
    std::array<float, 4> rotation{0.0F, 0.0F, 0.0F, 1.0F};  ///< unit quaternion x, y, z, w
};

struct Node {
    std::string name;
    std::vector<int> children;
    int mesh = -1;             ///< index, or -1
    Pose pose;                 ///< in the frame of its parent
    std::vector<Pose> motion;  ///< one for each time; empty: the node does not move
};

struct Scene {
    std::string name;
    std::vector<Node> nodes;  ///< the first is the root
    std::vector<Mesh> meshes;
    std::vector<float> times;  ///< of the animation, ascending [s]; empty if nothing moves
};

/// The scene as the bytes of a file. Between two times a rotation takes the shorter way.
/// @source Khronos, glTF 2.0 specification, sections 3.6, 3.11 and 4.4
std::vector<std::uint8_t> encode(const Scene& scene);

}  // namespace jw::gltf
