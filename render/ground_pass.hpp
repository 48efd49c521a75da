#pragma once

#include "render/gl_objects.hpp"
#include "render/scene_view.hpp"
#include "render/shadow_view.hpp"

namespace jw::render {

/// Draws the ground plane with the shadow of what is above it. Looking up soft shadows is what costs most of
/// a picture without a GPU; it is done where shadow can fall, and nowhere else.
class GroundPass {
public:
    explicit GroundPass(const GlFunctions& gl);

    /// Draws over what is there, with the shadow map of `shadow` bound; leaves no scissor but that of
    /// `viewport`.
    void draw(
        const SceneView& view, const Ground& ground, const ShadowView& shadow, const Rect& viewport,
        const FrameSize& frame, Tone tone, const Colour& plane) const;

private:
    void draw_plane(const DeviceRect& part) const;

    const GlFunctions& gl_;
    GlProgram lit_;
    GlProgram shadowed_;
    GlVertexArray no_attributes_;  // the plane is made of gl_VertexID alone
};

}  // namespace jw::render
