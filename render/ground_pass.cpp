#include "render/ground_pass.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "render/orbit.hpp"
#include "render/shaders.hpp"
#include "render/shadow_map.hpp"

namespace jw::render {
namespace {

constexpr Colour kNightShadow = from_hex(0x000000, 0.5F);

DeviceRect between(GLint left, GLint bottom, GLint right, GLint top) {
    return {left, bottom, std::max(right - left, 0), std::max(top - bottom, 0)};
}

DeviceRect common_part(const DeviceRect& a, const DeviceRect& b) {
    return between(
        std::max(a.x, b.x), std::max(a.y, b.y), std::min(a.x + a.width, b.x + b.width),
        std::min(a.y + a.height, b.y + b.height));
}

/// Room for samples beside the border: llvmpipe (Mesa 22.3) takes a scissor for exact to the pixel only, so
/// the shaders decide who draws a pixel, and no sample is blended twice.
DeviceRect grown(const DeviceRect& rect) { return {rect.x - 1, rect.y - 1, rect.width + 2, rect.height + 2}; }

void set_part(const GlProgram& program, const DeviceRect& shaded) {
    program.set("shaded_from", static_cast<float>(shaded.x), static_cast<float>(shaded.y));
    program.set(
        "shaded_to", static_cast<float>(shaded.x + shaded.width),
        static_cast<float>(shaded.y + shaded.height));
}

void set_uniforms(
    const GlProgram& program, const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) {
    const Vector3d normal = ground.normal.normalized();
    const Vector3d u = level_axis(normal);
    program.use();
    program.set("clip_from_world", view.clip_from_world);
    program.set("centre", ground.point);
    program.set("axis_u", u);
    program.set("axis_v", Vector3d(normal.cross(u)));
    program.set("radius", static_cast<float>(ground.radius));
    program.set("lines_per_radius", static_cast<float>(ground.radius / ground.grid));
    program.set("line_width", 1.1F * view.pixel_scale);
    program.set("plane_colour", plane);
    program.set("line_colour", toned(palette::kGroundLine, tone));
}

}  // namespace

GroundPass::GroundPass(const GlFunctions& gl)
    : gl_(gl),
      lit_(gl, "lit ground", shaders::ground_vertex(), shaders::ground_fragment(shaders::Shadows::none)),
      shadowed_(gl, "ground", shaders::ground_vertex(), shaders::ground_fragment(shaders::Shadows::soft)),
      no_attributes_(make_vertex_array(gl)) {}

void GroundPass::draw(
    const SceneView& view, const Ground& ground, const ShadowView& shadow, const Rect& viewport,
    const FrameSize& frame, Tone tone, const Colour& plane) const {
    const DeviceRect whole = device_rect(viewport, frame);
    const Rect reach =
        shadow_on_plane(shadow, ShadowMap::kBorder, view.camera, viewport, ground.point, ground.normal);
    const DeviceRect shaded = common_part(whole, device_rect(reach, frame));
    gl_.Enable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    // bodies that stand on the plane or sink into it stay whole
    gl_.DepthMask(GL_FALSE);
    gl_.BindVertexArray(no_attributes_.name());

    set_uniforms(lit_, view, ground, tone, plane);
    set_part(lit_, shaded);
    draw_plane(whole);
    if (shaded.width > 0 && shaded.height > 0) {
        set_uniforms(shadowed_, view, ground, tone, plane);
        set_part(shadowed_, shaded);
        shadowed_.set("shadow_from_world", shadow.map_from_world);
        // a shadow is darker than its ground in any tone
        shadowed_.set("shadow_colour", tone == Tone::light ? palette::kGroundShadow : kNightShadow);
        ShadowMap::set_uniforms(shadowed_);
        draw_plane(common_part(whole, grown(shaded)));
    }
    gl_.DepthMask(GL_TRUE);
    gl_.Scissor(whole.x, whole.y, whole.width, whole.height);
}

/// Draws the plane in one part; the triangles are the same in every part, so that no seam shows.
void GroundPass::draw_plane(const DeviceRect& part) const {
    gl_.Scissor(part.x, part.y, part.width, part.height);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace jw::render
