#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/passes/scene_view.hpp"
#include "render/passes/shadow_view.hpp"

namespace jw::render {

/// Draws the ground plane and the shadows on it. Without a GPU, most of the time of a picture goes into soft
/// shadows, so they are computed only where shadow can fall.
class GroundPass {
public:
    explicit GroundPass(const GlFunctions& gl);

    /// Draws the plane without shadows over the present content, inside the scissor. Needs no depth.
    void draw_lit(const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) const;

    /// Draws the shadows over the lit plane; the shadow map of `shadow` must be bound.
    /// @param part  there are no shadows outside of it; none: they can be anywhere
    void draw_shadow(
        const SceneView& view, const Ground& ground, const ShadowView& shadow,
        const std::optional<Parallelogram>& part, Tone tone) const;

private:
    void draw_plane() const;

    const GlFunctions& gl_;
    GlProgram lit_;
    GlProgram shadow_;
    GlVertexArray no_attributes_;  // the plane is computed from gl_VertexID alone
};

}  // namespace jw::render
