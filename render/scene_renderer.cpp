#include "render/scene_renderer.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "render/scene_view.hpp"
#include "render/shaders.hpp"

namespace jw::render {
namespace {

constexpr float kHiddenAlpha = 0.50F;  // of what is seen through a body
constexpr Colour kWhitePaper = from_hex(0xFFFFFF);

/// Lamps stand relative to the camera, so every view is lit well: key from the upper left behind the viewer,
/// fill from the right.
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

/// Values that all passes of one frame share.
struct SceneRenderer::Pass : SceneView {
    Tone tone;
    Light light;
    ShadowView shadow;

    Pass(const Scene& scene, const Camera& seen_by, const Rect& viewport, const FrameSize& frame, Tone tone_)
        : SceneView(scene, seen_by, viewport, frame, tone_), tone(tone_), light(light_for(scene, seen_by)) {
        Scene casters;
        casters.shapes = scene.shapes;
        shadow = shadow_view(bounds_of(casters), light.towards_key, ShadowMap::kTexels);
    }

    /// Uniforms of `shaders::body_vertex`.
    void set_vertex_uniforms(const GlProgram& program, float edge_scale) const {
        set_solid_uniforms(program, edge_scale);
        program.set("shadow_from_world", shadow.map_from_world);
        // one and a half texels: what a slope of 45 degrees rises within a tap and its neighbours
        program.set(
            "shadow_offset",
            static_cast<float>(
                1.5 * shadow.width / ShadowMap::kTexels + 0.4 * ShadowMap::kBorder * shadow.width));
    }
};

SceneRenderer::SceneRenderer(const GlFunctions& gl)
    : gl_(gl),
      body_(gl, "body", shaders::body_vertex(), shaders::body_fragment(shaders::Shadows::soft)),
      sign_(gl, "sign", shaders::body_vertex(), shaders::body_fragment(shaders::Shadows::none)),
      edge_(gl, "edge", shaders::body_vertex(), shaders::edge_fragment()),
      backdrop_(gl, "backdrop", shaders::backdrop_vertex(), shaders::backdrop_fragment()),
      line_(gl, "line", shaders::line_vertex(), shaders::line_fragment()),
      meshes_(gl),
      shadow_map_(gl),
      ground_(gl),
      no_attributes_(make_vertex_array(gl)) {}

void SceneRenderer::draw(
    const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame, Tone tone,
    Backdrop backdrop) const {
    const DeviceRect rect = device_rect(viewport, frame);
    if (rect.width < 1 || rect.height < 1) { return; }
    const Pass pass(scene, camera, viewport, frame, tone);
    shadow_map_.update(meshes_, pass.lists.bodies, pass.shadow);

    gl_.Viewport(rect.x, rect.y, rect.width, rect.height);
    gl_.Scissor(rect.x, rect.y, rect.width, rect.height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    shadow_map_.bind();
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    if (backdrop == Backdrop::sky) { draw_backdrop(tone); }
    if (scene.ground) {
        const Colour plane = backdrop == Backdrop::sky ? toned(palette::kGroundPlane, tone) : kWhitePaper;
        ground_.draw(pass, *scene.ground, pass.shadow, viewport, frame, tone, plane);
    }
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

void SceneRenderer::draw_backdrop(Tone tone) const {
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
    backdrop_.use();
    backdrop_.set("top", toned(palette::kSkyTop, tone));
    backdrop_.set("bottom", toned(palette::kSkyBottom, tone));
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Enable(GL_DEPTH_TEST);
}

void SceneRenderer::draw_bodies(const Pass& pass) const {
    gl_.Disable(GL_BLEND);
    shade(pass, pass.lists.bodies, kBody);
    draw_edges(pass, pass.lists.bodies);
    shade(pass, pass.lists.annotations, kAnnotation);
    draw_edges(pass, pass.lists.annotations);
}

void SceneRenderer::draw_see_through(const Pass& pass) const {
    // first the hidden parts, so that the visible ones cover their own far sides
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
    // where hidden, the halo shines through what it surrounds
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
    // depth first: only the front of each ghost is seen, not its inside
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
