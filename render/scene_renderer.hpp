#pragma once

#include "render/backdrop_pass.hpp"
#include "render/camera.hpp"
#include "render/gl_objects.hpp"
#include "render/instanced_meshes.hpp"
#include "render/render_targets.hpp"
#include "render/scene.hpp"
#include "render/shadow_map.hpp"

namespace jw::render {

/// Number of looks that pictures have had: one more each time that the same scene comes to look otherwise.
/// Golden pictures of an earlier look are compared without their colours.
inline constexpr int kLook = 2;

/// Draws scenes through a table of GL functions, whoever made the context.
///
/// Order of a frame: shadow map, backdrop, ground, bodies and their outlines, annotations, what is seen
/// through bodies, lines, what is highlighted of these, ghosts.
class SceneRenderer {
public:
    /// Compiles shaders and uploads meshes. The context must be current here, in `draw` and at destruction;
    /// `gl` must outlive this.
    /// @throws std::runtime_error with the driver's words if a shader does not compile.
    explicit SceneRenderer(const GlFunctions& gl);

    /// Draws into the rectangle `viewport` of the frame that `RenderTargets::begin_3d` has begun. The point
    /// that `project(camera, viewport, point)` names is where a point appears. Nothing is drawn into a
    /// viewport without pixels. Bodies have the same colours in both tones; everything else is `toned`.
    void draw(
        const Scene& scene, const Camera& camera, const Rect& viewport, const RenderTargets& targets,
        Tone tone = Tone::light, Backdrop backdrop = Backdrop::sky) const;

    /// Draws the shadows of a scene alone; `draw` of the same scene then has nothing more to do for them.
    void draw_shadows(
        const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame) const;

    /// Meshes for an `IdBuffer` of the same context.
    const SceneMeshes& meshes() const { return meshes_; }

private:
    struct Pass;

    /// Response of surfaces to light.
    struct Surface {
        float shadow_strength;  ///< of the key light, what a body can take from this one
        float flatness;         ///< 0: shaded, 1: its own colour whatever the light
        float alpha;
    };
    static const Surface kBody;
    static const Surface kAnnotation;  ///< vectors keep the colour that formulas and labels show
    static const Surface kHidden;      ///< what is seen through a body
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
