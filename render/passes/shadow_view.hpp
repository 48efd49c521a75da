#pragma once

#include <optional>

#include <Eigen/Core>

#include "render/scene/framing.hpp"

namespace jw::render {

/// The key light's view of the scene: parallel rays into a square depth map.
struct ShadowView {
    Eigen::Matrix4d map_from_world;   ///< x, y and depth from 0 to 1 inside the map
    Eigen::Matrix4d clip_from_world;  ///< the same for drawing into the map, -1 to 1
    double width = 1.0;               ///< of the map [m]
    // corners of the casters in the map; empty where lowest > highest
    Eigen::Vector2d lowest = Eigen::Vector2d::Ones();
    Eigen::Vector2d highest = Eigen::Vector2d::Zero();

    /// True if nothing casts a shadow.
    bool empty() const { return (lowest.array() > highest.array()).any(); }

    bool operator==(const ShadowView&) const = default;
};

/// Covers `casters` seen from the light. The width changes in steps, so that the borders of shadows do not
/// crawl from frame to frame while a scene moves.
/// @param towards_light  unit
/// @param texels  side of the map
ShadowView shadow_view(const Bounds& casters, const Eigen::Vector3d& towards_light, int texels);

/// A part of a plane: centre + x u + y v with x and y from -1 to 1.
struct Parallelogram {
    Vector3d centre;
    Vector3d u;
    Vector3d v;
};

/// The part of a plane that can be in shadow; nothing if rays graze the plane and can reach any place on it.
/// At least one body must cast a shadow.
/// @param border  widths of the map by which shadows are softened on each side
std::optional<Parallelogram> shadow_on_plane(
    const ShadowView& shadow, double border, const Vector3d& point, const Vector3d& normal);

/// Bounds of the corners of a part.
Bounds bounds_of(const Parallelogram& part);

}  // namespace jw::render
