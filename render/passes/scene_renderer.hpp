#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/gl/render_targets.hpp"
#include "render/passes/backdrop_pass.hpp"
#include "render/passes/instanced_meshes.hpp"
#include "render/passes/shadow_map.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/scene.hpp"

namespace jw::render {

/// Version of the appearance of pictures: it increases each time that the same scene looks different. Golden
/// pictures of an earlier version are compared without their colours.
inline constexpr int kLook = 2;

/// Draws scenes through a table of GL functions, in any context.
///
/// Order of a frame: shadow map, backdrop, ground, bodies and their outlines, annotations, what is visible
/// through bodies, lines, highlighted parts of these, ghosts.
class SceneRenderer {
public:
    /// Compiles shaders and uploads meshes. The context must be current here, in `draw` and at destruction;
    /// `gl` must outlive this object.
    /// @throws std::runtime_error with the message of the driver if a shader does not compile.
    explicit SceneRenderer(const GlFunctions& gl);

    /// Draws into the rectangle `viewport` of the frame that `RenderTargets::begin_3d` has begun. A point
    /// appears at `project(camera, viewport, point)`. Nothing is drawn into a viewport without pixels. Bodies
    /// have the same colours in both tones; everything else is `toned`.
    void draw(
        const Scene& scene, const Camera& camera, const Rect& viewport, const RenderTargets& targets,
        Tone tone = Tone::light, Backdrop backdrop = Backdrop::sky) const;

    /// Draws only the shadows of a scene; `draw` of the same scene then does not need to draw them.
    void draw_shadows(
        const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame) const;

    /// Meshes for an `IdBuffer` of the same context.
    const SceneMeshes& meshes() const { return meshes_; }

private:
    struct Pass;

    /// Response of surfaces to light.
    struct Surface {
        float shadow_strength;  ///< of the key light: how much of it a shadow can take from this surface
        float flatness;         ///< 0: shaded, 1: its own colour in any light
        float alpha;
    };
    static const Surface kBody;
    static const Surface kAnnotation;  ///< vectors keep the colour that formulas and labels show
    static const Surface kHidden;      ///< what is visible through a body
    static const Surface kGhost;

    void draw_solids(const Pass& pass, const DeviceRect& part) const;
    void draw_bodies(const Pass& pass) const;
    void draw_see_through(const Pass& pass) const;
    void draw_emphasised(const Pass& pass) const;
    void draw_ghosts(const Pass& pass) const;

    void shade(const Pass& pass, const InstanceLists& lists, const Surface& surface) const;
    void draw_edges(const Pass& pass, const InstanceLists& lists) const;
    void draw_lines(const Pass& pass, const std::vector<LineSegment>& lines, float alpha) const;

    const GlFunctions& gl_;
    GlProgram body_;
    GlProgram sign_;  // the same without shadows
    GlProgram edge_;
    GlProgram line_;
    SceneMeshes meshes_;
    mutable ShadowMap shadow_map_;   // remembers what it shows
    mutable BackdropPass backdrop_;  // likewise
};

}  // namespace jw::render
