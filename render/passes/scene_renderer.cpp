#include "render/passes/scene_renderer.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "render/gl/shaders.hpp"
#include "render/passes/instances.hpp"
#include "render/passes/scene_view.hpp"

namespace jw::render {
namespace {

constexpr float kHiddenAlpha = 0.50F;  // of what is visible through a body

/// Lights are placed relative to the camera, so that every view is lit well: the key light from the upper
/// left behind the viewer, the fill light from the right.
struct Light {
    Vector3d towards_key;
    Vector3d towards_fill;
    Vector3d up;
};

Light light_for(const Scene& scene, const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    const Vector3d up = scene.ground ? scene.ground->normal.normalized() : camera.up.normalized();
    return {
        (1.20 * up - 0.62 * axes.right - 0.72 * axes.forward).normalized(),
        (0.25 * up + 0.85 * axes.right - 0.45 * axes.forward).normalized(),
        up,
    };
}

}  // namespace

const SceneRenderer::Surface SceneRenderer::kBody{0.75F, 0.0F, 1.0F};
const SceneRenderer::Surface SceneRenderer::kAnnotation{0.0F, 0.45F, 1.0F};
const SceneRenderer::Surface SceneRenderer::kHidden{0.0F, 0.45F, kHiddenAlpha};
const SceneRenderer::Surface SceneRenderer::kGhost{0.0F, 0.0F, 1.0F};

/// Values that all passes of a frame share.
struct SceneRenderer::Pass : SceneView {
    Rect seen_in;
    Light light;
    ShadowView shadow;

    Pass(const Scene& scene, const Camera& seen_by, const Rect& viewport, const FrameSize& frame, Tone tone_)
        : SceneView(scene, seen_by, viewport, frame, tone_),
          seen_in(viewport),
          light(light_for(scene, seen_by)),
          shadow(shadow_view(bounds_of_shapes(scene.shapes), light.towards_key, ShadowMap::kTexels)) {}

    /// Part of the picture that bodies, lines and outlines cover; it may extend beyond the viewport.
    Rect reached(const FrameSize& frame) const {
        // 1 pixel: soft borders of lines
        const double border = 1.0 + border_of(lists) * static_cast<double>(pixel_scale) / frame.pixel_ratio;
        return shrunk(seen_part(bounds_of(lists), camera, seen_in), -std::ceil(border));
    }

    /// Uniforms of `shaders::kBodyVertex`.
    void set_vertex_uniforms(const GlProgram& program, float edge_scale) const {
        set_solid_uniforms(program, edge_scale);
        program.set("shadow_from_world", shadow.map_from_world);
        // one and a half texels: the rise of a slope of 45 degrees within a tap and its neighbours
        program.set(
            "shadow_offset",
            static_cast<float>(
                1.5 * shadow.width / ShadowMap::kTexels + 0.4 * ShadowMap::kBorder * shadow.width));
    }
};

SceneRenderer::SceneRenderer(const GlFunctions& gl)
    : gl_(gl),
      body_(gl, "body", shaders::kBodyVertex, shaders::body_fragment(shaders::Shadows::soft)),
      sign_(gl, "sign", shaders::kBodyVertex, shaders::body_fragment(shaders::Shadows::none)),
      edge_(gl, "edge", shaders::kBodyVertex, shaders::kEdgeFragment),
      line_(gl, "line", shaders::kLineVertex, shaders::kLineFragment),
      meshes_(gl),
      shadow_map_(gl),
      backdrop_(gl) {}

void SceneRenderer::draw(
    const Scene& scene, const Camera& camera, const Rect& viewport, const RenderTargets& targets, Tone tone,
    Backdrop backdrop) const {
    const FrameSize frame = targets.size();
    const DeviceRect rect = device_rect(viewport, frame, targets.part());
    const DeviceRect shown = shown_rect(viewport, frame, targets.part());
    if (shown.empty()) { return; }
    const Pass pass(scene, camera, viewport, frame, tone);
    shadow_map_.update(meshes_, pass.lists.bodies, pass.shadow);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    backdrop_.draw(
        {pass.clip_from_world, viewport, frame, targets.part(), tone, backdrop, targets.paper(),
         scene.ground},
        pass, shadow_map_);

    const DeviceRect part = common_part(shown, device_rect(pass.reached(frame), frame, targets.part()));
    if (part.empty()) { return; }
    targets.begin_bodies();
    gl_.Viewport(rect.x, rect.y, rect.width, rect.height);
    draw_solids(pass, part);
    targets.end_bodies(part);
}

/// Draws everything but the backdrop, which is copied below it.
void SceneRenderer::draw_solids(const Pass& pass, const DeviceRect& part) const {
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(part.x, part.y, part.width, part.height);
    backdrop_.draw_behind_bodies();
    shadow_map_.bind();
    gl_.DepthFunc(GL_LESS);
    draw_bodies(pass);
    draw_see_through(pass);
    draw_emphasised(pass);
    draw_ghosts(pass);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
}

void SceneRenderer::draw_shadows(
    const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame) const {
    const Pass pass(scene, camera, viewport, frame, Tone::light);
    shadow_map_.update(meshes_, pass.lists.bodies, pass.shadow);
}

void SceneRenderer::draw_bodies(const Pass& pass) const {
    gl_.Disable(GL_BLEND);
    shade(pass, pass.lists.bodies, kBody);
    draw_edges(pass, pass.lists.bodies);
    shade(pass, pass.lists.annotations, kAnnotation);
    draw_edges(pass, pass.lists.annotations);
}

void SceneRenderer::draw_see_through(const Pass& pass) const {
    // hidden parts first, so that the visible parts cover their own far sides
    gl_.DepthFunc(GL_GREATER);
    draw_lines(pass, pass.lists.see_through_lines, kHiddenAlpha);
    gl_.Enable(GL_BLEND);
    gl_.DepthMask(GL_FALSE);
    shade(pass, pass.lists.see_through, kHidden);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);

    gl_.DepthFunc(GL_LESS);
    shade(pass, pass.lists.see_through, kAnnotation);
    draw_edges(pass, pass.lists.see_through);
    draw_lines(pass, pass.lists.lines, 1.0F);
    draw_lines(pass, pass.lists.see_through_lines, 1.0F);
}

void SceneRenderer::draw_emphasised(const Pass& pass) const {
    // where hidden, the halo is visible through what it surrounds
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_FALSE);
    draw_edges(pass, pass.lists.emphasised);
    gl_.Enable(GL_BLEND);
    shade(pass, pass.lists.emphasised, kHidden);
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LESS);
    shade(pass, pass.lists.emphasised, kAnnotation);
    draw_edges(pass, pass.lists.emphasised);
}

void SceneRenderer::draw_ghosts(const Pass& pass) const {
    // depth first: only the front of each ghost is visible, not its inside
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.Disable(GL_BLEND);
    shade(pass, pass.lists.ghosts, kGhost);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.Enable(GL_BLEND);
    gl_.DepthFunc(GL_LEQUAL);
    shade(pass, pass.lists.ghosts, kGhost);
    gl_.DepthFunc(GL_LESS);
    draw_edges(pass, pass.lists.ghosts);
    gl_.Disable(GL_BLEND);
}

void SceneRenderer::shade(const Pass& pass, const InstanceLists& lists, const Surface& surface) const {
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_BACK);
    const GlProgram& program = surface.shadow_strength > 0.0F ? body_ : sign_;
    program.use();
    pass.set_vertex_uniforms(program, 0.0F);
    ShadowMap::set_uniforms(program);
    program.set("eye", pass.camera.eye);
    program.set(
        "parallel_view",
        pass.camera.orthographic ? Vector3d(-axes_of(pass.camera).forward) : Vector3d(Vector3d::Zero()));
    program.set("towards_key", pass.light.towards_key);
    program.set("towards_fill", pass.light.towards_fill);
    program.set("up", pass.light.up);
    program.set("shadow_strength", surface.shadow_strength);
    program.set("flatness", surface.flatness);
    program.set("alpha_scale", surface.alpha);
    meshes_.solids.draw(lists);
}

void SceneRenderer::draw_edges(const Pass& pass, const InstanceLists& lists) const {
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_FRONT);
    edge_.use();
    pass.set_vertex_uniforms(edge_, pass.pixel_scale);
    meshes_.solids.draw(lists);
    gl_.CullFace(GL_BACK);
}

void SceneRenderer::draw_lines(const Pass& pass, const std::vector<LineSegment>& lines, float alpha) const {
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_BLEND);
    // the soft border of one segment must not hide the next
    gl_.DepthMask(GL_FALSE);
    line_.use();
    pass.set_line_uniforms(line_);
    line_.set("alpha_scale", alpha);
    meshes_.lines.draw(lines);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
}

}  // namespace jw::render
