#pragma once

#include "render/gl_objects.hpp"
#include "render/scene_view.hpp"
#include "render/shadow_view.hpp"

namespace jw::render {

/// Draws the ground plane and, on it, the shadow of what is above. Looking up soft shadows is what costs most
/// of a picture without a GPU; it is done where shadow can fall, and nowhere else.
class GroundPass {
public:
    explicit GroundPass(const GlFunctions& gl);

    /// Draws over what is there, inside the scissor, as if nothing cast a shadow. Needs no depth.
    void draw_lit(const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) const;

    /// Draws shadows over that, with the shadow map of `shadow` bound.
    /// @param part  outside of which there are none; none: anywhere
    void draw_shadow(
        const SceneView& view, const Ground& ground, const ShadowView& shadow,
        const std::optional<Parallelogram>& part, Tone tone) const;

private:
    void draw_plane() const;

    const GlFunctions& gl_;
    GlProgram lit_;
    GlProgram shadow_;
    GlVertexArray no_attributes_;  // the plane is made of gl_VertexID alone
};

}  // namespace jw::render
