#pragma once

#include <cstdint>
#include <optional>

#include "render/gl/gl_objects.hpp"
#include "render/passes/scene_view.hpp"
#include "render/passes/shadow_map.hpp"
#include "render/scene/scene.hpp"

namespace jw::render {

/// Background that is drawn behind everything else.
enum class Backdrop {
    sky,    ///< a gradient from top to bottom
    paper,  ///< the paper of the framebuffer; only the lines and shadows of the ground are seen
};

/// One viewport of a frame, its tone and the backdrop behind its bodies.
struct BackdropView {
    Matrix4d clip_from_world;
    Rect viewport;
    FrameSize frame;
    FramePart part;  ///< part that is drawn
    Tone tone = Tone::light;
    Backdrop backdrop = Backdrop::sky;
    Colour paper;
    std::optional<Ground> ground;

    bool operator==(const BackdropView&) const = default;
};

/// Draws the backdrop behind the bodies: sky, ground and the shadows on it.
///
/// Nothing in the backdrop has an edge that needs more than one sample per pixel, and most of it does not
/// change while bodies move. So it is painted into a texture with one sample, which is kept. Only what has
/// changed is painted again: everything after a change of camera, size or tone, and the part in shadow when
/// bodies move. Without a GPU, this saves a third of the time of a picture. Most of the rest goes into soft
/// shadows, so they are computed only where shadow can fall.
class BackdropPass {
public:
    explicit BackdropPass(const GlFunctions& gl);

    /// Fills the viewport of the bound framebuffer, which has one sample. Leaves the map of `shadows` bound
    /// to texture unit 0.
    void draw(const BackdropView& wanted, const SceneView& view, const ShadowMap& shadows);

    /// Fills the scissor of the bound framebuffer, for any number of samples, with the last backdrop, at the
    /// farthest depth. Uses texture unit 0.
    void draw_behind_bodies() const;

private:
    /// A texture with one sample that can be drawn into.
    struct Layer {
        GlTexture texture;
        GlFramebuffer framebuffer;
    };

    Layer make_layer() const;
    void resize(const BackdropView& wanted);
    void paint_lit(const BackdropView& wanted, const SceneView& view);
    void paint_shown(
        const BackdropView& wanted, const SceneView& view, const ShadowMap& shadows, bool lit_changed);
    void paint_behind_ground(const BackdropView& wanted) const;
    void draw_lit_ground(const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) const;
    void draw_ground_shadow(
        const SceneView& view, const Ground& ground, const ShadowView& shadow,
        const std::optional<Parallelogram>& part, Tone tone) const;
    void draw_plane() const;
    void fill() const;

    const GlFunctions& gl_;
    GlProgram sky_;
    GlProgram copy_;
    GlProgram lit_ground_;
    GlProgram ground_shadow_;
    GlVertexArray no_attributes_;  // for triangles made of gl_VertexID alone
    Layer lit_;                    // without shadows
    Layer shown_;
    DeviceRect size_{};                 // of both layers
    std::optional<BackdropView> view_;  // shown by both layers
    std::uint64_t shadows_ = 0;         // version of the shadows in `shown_`
    DeviceRect shaded_{};               // part of `shown_` that differs from `lit_`
};

}  // namespace jw::render
