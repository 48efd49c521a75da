#include "render/passes/backdrop_pass.hpp"

#include <Eigen/Geometry>

#include "render/gl/shaders.hpp"
#include "render/scene/orbit.hpp"

namespace jw::render {

namespace {

constexpr Colour kNightShadow = from_hex(0x000000, 0.5F);

/// The whole plane that is drawn.
Parallelogram whole_plane(const Ground& ground) {
    const Vector3d normal = ground.normal.normalized();
    const Vector3d u = level_axis(normal);
    return {ground.point, ground.radius * u, ground.radius * normal.cross(u)};
}

/// Coordinates x and y in the plane, in units of its radius.
Matrix4d plane_from_world(const Ground& ground) {
    const Parallelogram plane = whole_plane(ground);
    Matrix4d m = Matrix4d::Identity();
    for (int row = 0; row < 2; ++row) {
        const Vector3d axis = (row == 0 ? plane.u : plane.v) / (ground.radius * ground.radius);
        m.block<1, 3>(row, 0) = axis.transpose();
        m(row, 3) = -axis.dot(ground.point);
    }
    return m;
}

/// Uniforms of `shaders::kGroundVertex` except those of shadows.
void set_vertex_uniforms(
    const GlProgram& program, const SceneView& view, const Ground& ground, const Parallelogram& part) {
    program.use();
    program.set("clip_from_world", view.clip_from_world);
    program.set("centre", part.centre);
    program.set("half_u", part.u);
    program.set("half_v", part.v);
    program.set("plane_from_world", plane_from_world(ground));
}

}  // namespace

BackdropPass::BackdropPass(const GlFunctions& gl)
    : gl_(gl),
      sky_(gl, "sky", shaders::kBackdropVertex, shaders::kSkyFragment),
      copy_(gl, "backdrop", shaders::kBackdropVertex, shaders::kCopyFragment),
      lit_ground_(gl, "ground", shaders::kGroundVertex, shaders::ground_fragment()),
      ground_shadow_(gl, "ground shadow", shaders::kGroundVertex, shaders::ground_shadow_fragment()),
      no_attributes_(GlVertexArray::make(gl)),
      lit_(make_layer()),
      shown_(make_layer()) {}

BackdropPass::Layer BackdropPass::make_layer() const {
    Layer layer{GlTexture::make(gl_), GlFramebuffer::make(gl_)};
    gl_.BindTexture(GL_TEXTURE_2D, layer.texture.name());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const BoundFramebuffer bound(gl_, layer.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer.texture.name(), 0);
    return layer;
}

/// The textures have the size of the frame's buffers, not of the viewport: so a pixel has the coordinates,
/// and exactly the colour, that it would have if it were drawn into the frame itself.
void BackdropPass::resize(const BackdropView& wanted) {
    const DeviceRect size = device_rect(wanted.part, wanted.frame);
    if (size_ == size) { return; }
    for (const Layer* layer : {&lit_, &shown_}) {
        gl_.BindTexture(GL_TEXTURE_2D, layer->texture.name());
        gl_.TexImage2D(
            GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    }
    size_ = size;
}

void BackdropPass::draw(const BackdropView& wanted, const SceneView& view, const ShadowMap& shadows) {
    const DeviceRect rect = device_rect(wanted.viewport, wanted.frame, wanted.part);
    const DeviceRect whole = shown_rect(wanted.viewport, wanted.frame, wanted.part);
    const bool lit_changed = view_ != wanted;
    if (lit_changed || shadows_ != shadows.version()) {
        // after an error, nothing counts as painted
        view_.reset();
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.Viewport(rect.x, rect.y, rect.width, rect.height);
        gl_.Enable(GL_SCISSOR_TEST);
        gl_.Scissor(whole.x, whole.y, whole.width, whole.height);
        gl_.Disable(GL_DEPTH_TEST);
        if (lit_changed) {
            resize(wanted);
            paint_lit(wanted, view);
        }
        paint_shown(wanted, view, shadows, lit_changed);
        gl_.Disable(GL_SCISSOR_TEST);
        view_ = wanted;
        shadows_ = shadows.version();
    }
    copy_part(gl_, shown_.framebuffer, whole);
}

void BackdropPass::paint_lit(const BackdropView& wanted, const SceneView& view) {
    const BoundFramebuffer bound(gl_, lit_.framebuffer);
    paint_behind_ground(wanted);
    if (!wanted.ground) { return; }
    const bool is_paper = wanted.backdrop == Backdrop::paper;
    draw_lit_ground(
        view, *wanted.ground, wanted.tone,
        is_paper ? wanted.paper : toned(palette::kGroundPlane, wanted.tone));
}

void BackdropPass::paint_shown(
    const BackdropView& wanted, const SceneView& view, const ShadowMap& shadows, bool lit_changed) {
    const DeviceRect whole = shown_rect(wanted.viewport, wanted.frame, wanted.part);
    const BoundFramebuffer bound(gl_, shown_.framebuffer);
    copy_part(gl_, lit_.framebuffer, lit_changed ? whole : shaded_);
    shaded_ = {};
    const ShadowView& shadow = shadows.view();
    if (!wanted.ground || shadow.empty()) { return; }
    const std::optional<Parallelogram> part =
        shadow_on_plane(shadow, ShadowMap::kBorder, wanted.ground->point, wanted.ground->normal);
    const Rect seen = part ? seen_part(bounds_of(*part), view.camera, wanted.viewport) : wanted.viewport;
    shaded_ = common_part(whole, device_rect(seen, wanted.frame, wanted.part));
    shadows.bind();
    draw_ground_shadow(view, *wanted.ground, shadow, part, wanted.tone);
}

void BackdropPass::paint_behind_ground(const BackdropView& wanted) const {
    if (wanted.backdrop == Backdrop::paper) {
        gl_.ClearColor(wanted.paper.r, wanted.paper.g, wanted.paper.b, wanted.paper.a);
        gl_.Clear(GL_COLOR_BUFFER_BIT);
        return;
    }
    sky_.use();
    sky_.set("top", toned(palette::kSkyTop, wanted.tone));
    sky_.set("bottom", toned(palette::kSkyBottom, wanted.tone));
    fill();
}

void BackdropPass::draw_behind_bodies() const {
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_ALWAYS);
    gl_.DepthMask(GL_TRUE);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, shown_.texture.name());
    copy_.use();
    copy_.set("picture", 0);
    fill();
}

/// Fills the viewport with the program in use, at the farthest depth.
void BackdropPass::fill() const {
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// Draws the plane without shadows over the present content, inside the scissor. Needs no depth.
void BackdropPass::draw_lit_ground(
    const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) const {
    set_vertex_uniforms(lit_ground_, view, ground, whole_plane(ground));
    lit_ground_.set("lines_per_radius", static_cast<float>(ground.radius / ground.grid));
    lit_ground_.set("line_width", 1.1F * view.pixel_scale);
    lit_ground_.set("plane_colour", plane);
    lit_ground_.set("line_colour", toned(palette::kGroundLine, tone));
    draw_plane();
}

/// Draws the shadows over the lit plane; the shadow map of `shadow` must be bound.
/// @param part  part of the plane outside which there are no shadows; empty if they can be anywhere
void BackdropPass::draw_ground_shadow(
    const SceneView& view, const Ground& ground, const ShadowView& shadow,
    const std::optional<Parallelogram>& part, Tone tone) const {
    set_vertex_uniforms(ground_shadow_, view, ground, part ? *part : whole_plane(ground));
    ground_shadow_.set("shadow_from_world", shadow.map_from_world);
    // a shadow is darker than its ground in both tones
    ground_shadow_.set("shadow_colour", tone == Tone::light ? palette::kGroundShadow : kNightShadow);
    ShadowMap::set_uniforms(ground_shadow_);
    draw_plane();
}

void BackdropPass::draw_plane() const {
    gl_.Enable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.Disable(GL_BLEND);
}

}  // namespace jw::render
