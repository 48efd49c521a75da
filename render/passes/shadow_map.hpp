#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "render/gl/gl_objects.hpp"
#include "render/passes/instanced_meshes.hpp"
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

/// The key light's picture of the bodies: how far its rays reach.
class ShadowMap {
public:
    static constexpr int kTexels = 512;
    static constexpr double kBorder = 0.006;  ///< width of soft borders of shadows, in widths of the map

    explicit ShadowMap(const GlFunctions& gl);

    /// Draws `casters`, unless the map already shows exactly these in this view. The framebuffer that was
    /// bound stays bound.
    void update(const SceneMeshes& meshes, const InstanceLists& casters, const ShadowView& view);

    /// Number of times that the map has been drawn: the shadows are the same as long as this number is the
    /// same.
    std::uint64_t version() const { return version_; }

    /// View that the map shows; `update` must have been called.
    const ShadowView& view() const { return shown_->view; }

    /// Binds the map to texture unit 0.
    void bind() const;

    /// Uniforms of the fragment shaders that read shadows.
    static void set_uniforms(const GlProgram& program);

private:
    struct Shown {
        InstanceLists casters;
        ShadowView view;

        bool operator==(const Shown&) const = default;
    };

    const GlFunctions& gl_;
    GlProgram depth_;
    GlTexture map_;
    GlFramebuffer framebuffer_;
    std::optional<Shown> shown_;
    std::uint64_t version_ = 0;
};

}  // namespace jw::render
