#include "render/passes/ground_pass.hpp"

#include <Eigen/Geometry>

#include "render/gl/shaders.hpp"
#include "render/passes/shadow_map.hpp"
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

/// Uniforms of `shaders::ground_vertex` except those of shadows.
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

GroundPass::GroundPass(const GlFunctions& gl)
    : gl_(gl),
      lit_(gl, "ground", shaders::ground_vertex(), shaders::ground_fragment()),
      shadow_(gl, "ground shadow", shaders::ground_vertex(), shaders::ground_shadow_fragment()),
      no_attributes_(make_vertex_array(gl)) {}

void GroundPass::draw_lit(const SceneView& view, const Ground& ground, Tone tone, const Colour& plane) const {
    set_vertex_uniforms(lit_, view, ground, whole_plane(ground));
    lit_.set("lines_per_radius", static_cast<float>(ground.radius / ground.grid));
    lit_.set("line_width", 1.1F * view.pixel_scale);
    lit_.set("plane_colour", plane);
    lit_.set("line_colour", toned(palette::kGroundLine, tone));
    draw_plane();
}

void GroundPass::draw_shadow(
    const SceneView& view, const Ground& ground, const ShadowView& shadow,
    const std::optional<Parallelogram>& part, Tone tone) const {
    set_vertex_uniforms(shadow_, view, ground, part ? *part : whole_plane(ground));
    shadow_.set("shadow_from_world", shadow.map_from_world);
    // a shadow is darker than its ground in both tones
    shadow_.set("shadow_colour", tone == Tone::light ? palette::kGroundShadow : kNightShadow);
    ShadowMap::set_uniforms(shadow_);
    draw_plane();
}

void GroundPass::draw_plane() const {
    gl_.Enable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.Disable(GL_BLEND);
}

}  // namespace jw::render
