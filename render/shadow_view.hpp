#pragma once

#include <Eigen/Core>

#include "render/framing.hpp"

namespace jw::render {

/// The key light's view of the scene: parallel rays into a square depth map.
struct ShadowView {
    Eigen::Matrix4d map_from_world;   ///< x, y and depth from 0 to 1 inside the map
    Eigen::Matrix4d clip_from_world;  ///< the same for drawing into the map, -1 to 1
    double width = 1.0;               ///< of the map [m]
};

/// Covers `casters` seen from the light. The width is stepped so that a moving scene does not make the
/// borders of its shadow crawl from frame to frame.
/// @param towards_light  unit
/// @param texels  side of the map
ShadowView shadow_view(const Bounds& casters, const Eigen::Vector3d& towards_light, int texels);

}  // namespace jw::render
