#include "render/scene_renderer.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "render/orbit.hpp"
#include "render/scene_view.hpp"
#include "render/shaders.hpp"

namespace jw::render {
namespace {

constexpr int kShadowTexels = 1024;
constexpr Colour kNightShadow = from_hex(0x000000, 0.5F);
constexpr double kShadowBorder = 0.006;  // softness of shadows, in widths of the map
constexpr float kHiddenAlpha = 0.50F;    // of what is seen through a body

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

GlTexture make_shadow_map(const GlFunctions& gl) {
    GlTexture map = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, map.name());
    gl.TexImage2D(
        GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowTexels, kShadowTexels, 0, GL_DEPTH_COMPONENT,
        GL_UNSIGNED_INT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // beyond the map everything is lit
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr GLfloat farthest[] = {1.0F, 1.0F, 1.0F, 1.0F};
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest);
    return map;
}

/// Leaves the framebuffer that was bound bound.
GlFramebuffer make_shadow_framebuffer(const GlFunctions& gl, const GlTexture& map) {
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    GlFramebuffer framebuffer = make_framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.name(), 0);
    constexpr GLenum no_colour = GL_NONE;
    gl.DrawBuffers(1, &no_colour);
    gl.ReadBuffer(GL_NONE);
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
    return framebuffer;
}

}  // namespace

const SceneRenderer::Surface SceneRenderer::kBody{0.75F, 0.0F, 1.0F};
const SceneRenderer::Surface SceneRenderer::kAnnotation{0.0F, 0.45F, 1.0F};
const SceneRenderer::Surface SceneRenderer::kHidden{0.0F, 0.45F, kHiddenAlpha};
const SceneRenderer::Surface SceneRenderer::kGhost{0.0F, 0.0F, 1.0F};

/// What all steps of one frame share.
struct SceneRenderer::Pass : SceneView {
    Tone tone;
    Light light;
    ShadowView shadow;

    Pass(const Scene& scene, const Camera& seen_by, const Rect& viewport, const FrameSize& frame, Tone tone_)
        : SceneView(scene, seen_by, viewport, frame, tone_), tone(tone_), light(light_for(scene, seen_by)) {
        Scene casters;
        casters.shapes = scene.shapes;
        shadow = shadow_view(bounds_of(casters), light.towards_key, kShadowTexels);
    }

    /// Uniforms of `shaders::body_vertex`.
    void set_vertex_uniforms(const GlProgram& program, float edge_scale) const {
        set_solid_uniforms(program, edge_scale);
        program.set("shadow_from_world", shadow.map_from_world);
        // one and a half texels: what a slope of 45 degrees rises within a tap and its neighbours
        program.set(
            "shadow_offset",
            static_cast<float>(1.5 * shadow.width / kShadowTexels + 0.4 * kShadowBorder * shadow.width));
    }
    void set_shadow_uniforms(const GlProgram& program) const {
        program.set("shadow_map", 0);
        program.set("shadow_spread", static_cast<float>(kShadowBorder));
    }
};

SceneRenderer::SceneRenderer(const GlFunctions& gl)
    : gl_(gl),
      body_(gl, "body", shaders::body_vertex(), shaders::body_fragment()),
      edge_(gl, "edge", shaders::body_vertex(), shaders::edge_fragment()),
      depth_(gl, "depth", shaders::body_vertex(), shaders::depth_fragment()),
      ground_(gl, "ground", shaders::ground_vertex(), shaders::ground_fragment()),
      backdrop_(gl, "backdrop", shaders::backdrop_vertex(), shaders::backdrop_fragment()),
      line_(gl, "line", shaders::line_vertex(), shaders::line_fragment()),
      meshes_(gl),
      no_attributes_(make_vertex_array(gl)),
      shadow_map_(make_shadow_map(gl)),
      shadow_framebuffer_(make_shadow_framebuffer(gl, shadow_map_)) {}

void SceneRenderer::draw(
    const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame, Tone tone) const {
    const DeviceRect rect = device_rect(viewport, frame);
    if (rect.width < 1 || rect.height < 1) { return; }
    const Pass pass(scene, camera, viewport, frame, tone);
    draw_shadow_map(pass);

    gl_.Viewport(rect.x, rect.y, rect.width, rect.height);
    gl_.Scissor(rect.x, rect.y, rect.width, rect.height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, shadow_map_.name());
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    draw_backdrop(tone);
    if (scene.ground) { draw_ground(pass, *scene.ground); }
    draw_bodies(pass);
    draw_see_through(pass);
    draw_emphasised(pass);
    draw_ghosts(pass);

    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
}

void SceneRenderer::draw_shadow_map(const Pass& pass) const {
    GLint bound = 0;
    gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_.name());
    gl_.Viewport(0, 0, kShadowTexels, kShadowTexels);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_BACK);
    depth_.use();
    pass.set_vertex_uniforms(depth_, 0.0F);
    depth_.set("clip_from_world", pass.shadow.clip_from_world);
    meshes_.solids.draw(pass.lists.bodies);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
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

void SceneRenderer::draw_ground(const Pass& pass, const Ground& ground) const {
    const Vector3d normal = ground.normal.normalized();
    const Vector3d u = level_axis(normal);
    ground_.use();
    ground_.set("clip_from_world", pass.clip_from_world);
    ground_.set("shadow_from_world", pass.shadow.map_from_world);
    pass.set_shadow_uniforms(ground_);
    ground_.set("centre", ground.point);
    ground_.set("axis_u", u);
    ground_.set("axis_v", Vector3d(normal.cross(u)));
    ground_.set("radius", static_cast<float>(ground.radius));
    ground_.set("lines_per_radius", static_cast<float>(ground.radius / ground.grid));
    ground_.set("line_width", 1.1F * pass.pixel_scale);
    ground_.set("plane_colour", toned(palette::kGroundPlane, pass.tone));
    ground_.set("line_colour", toned(palette::kGroundLine, pass.tone));
    // a shadow is darker than its ground in any tone
    ground_.set("shadow_colour", pass.tone == Tone::light ? palette::kGroundShadow : kNightShadow);
    gl_.Enable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    // bodies that stand on the plane or sink into it stay whole
    gl_.DepthMask(GL_FALSE);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.DepthMask(GL_TRUE);
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
    body_.use();
    pass.set_vertex_uniforms(body_, 0.0F);
    pass.set_shadow_uniforms(body_);
    body_.set("eye", pass.camera.eye);
    body_.set(
        "parallel_view",
        pass.camera.orthographic ? Vector3d(-axes_of(pass.camera).forward) : Vector3d(Vector3d::Zero()));
    body_.set("towards_key", pass.light.towards_key);
    body_.set("towards_fill", pass.light.towards_fill);
    body_.set("up", pass.light.up);
    body_.set("shadow_strength", surface.shadow_strength);
    body_.set("flatness", surface.flatness);
    body_.set("alpha_scale", surface.alpha);
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
