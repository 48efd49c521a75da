#include "render/passes/shadow_map.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "render/gl/shaders.hpp"

namespace jw::render {

namespace {

GlTexture make_map(const GlFunctions& gl) {
    auto map = GlTexture::make(gl);
    gl.BindTexture(GL_TEXTURE_2D, map.name());
    gl.TexImage2D(
        GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, ShadowMap::kTexels, ShadowMap::kTexels, 0, GL_DEPTH_COMPONENT,
        GL_UNSIGNED_INT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // everything outside the map is lit, like its border, which no shadow reaches (kMargin)
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return map;
}

/// The framebuffer that was bound stays bound.
GlFramebuffer make_framebuffer_of(const GlFunctions& gl, const GlTexture& map) {
    auto framebuffer = GlFramebuffer::make(gl);
    const BoundFramebuffer bound(gl, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.name(), 0);
    constexpr GLenum no_colour = GL_NONE;
    gl.DrawBuffers(1, &no_colour);
    gl.ReadBuffer(GL_NONE);
    return framebuffer;
}

constexpr double kMargin = 1.15;  // space for the soft border, and a border of the map that stays lit
constexpr double kStep = 1.25;    // widths are powers of this

constexpr double kGrazing = 0.05;
constexpr double kTexelMargin = 0.01;  // of the map: ten texels, for blending and for rounding

/// The multiple of `step` that is nearest to `value`.
double snapped(double value, double step) { return std::round(value / step) * step; }

}  // namespace

ShadowMap::ShadowMap(const GlFunctions& gl)
    : gl_(gl),
      depth_(gl, "depth", shaders::kBodyVertex, shaders::kDepthFragment),
      map_(make_map(gl)),
      framebuffer_(make_framebuffer_of(gl, map_)) {}

void ShadowMap::update(const SceneMeshes& meshes, const InstanceLists& casters, const ShadowView& view) {
    if (shown_ && shown_->casters == casters && shown_->view == view) { return; }
    const BoundFramebuffer bound(gl_, framebuffer_);
    gl_.Viewport(0, 0, kTexels, kTexels);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_BACK);
    depth_.use();
    depth_.set("clip_from_world", view.clip_from_world);
    depth_.set("clip_per_pixel", 1.0F, 1.0F);
    depth_.set("edge_scale", 0.0F);
    meshes.solids.draw(casters);
    shown_ = Shown{casters, view};
    ++version_;
}

void ShadowMap::bind() const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, map_.name());
}

void ShadowMap::set_uniforms(const GlProgram& program) {
    program.set("shadow_map", 0);
    program.set("shadow_spread", static_cast<float>(kBorder));
}

ShadowView shadow_view(const Bounds& casters, const Eigen::Vector3d& towards_light, int texels) {
    const double diagonal = std::max(casters.diagonal(), 1e-3);
    const double width = std::pow(kStep, std::ceil(std::log(kMargin * diagonal) / std::log(kStep)));
    const double texel = width / texels;

    Eigen::Matrix3d light;
    light.row(2) = towards_light;
    light.row(0) = towards_light.unitOrthogonal();
    light.row(1) = towards_light.cross(light.row(0).transpose());
    const Eigen::Vector3d centre = light * (casters.empty() ? Eigen::Vector3d::Zero() : casters.centre());

    ShadowView view;
    view.width = width;
    view.clip_from_world.setIdentity();
    view.clip_from_world.block<3, 3>(0, 0) = light * (2.0 / width);
    view.clip_from_world.block<1, 3>(2, 0) *= -0.5;  // the ground may lie far below: twice the depth
    view.clip_from_world(0, 3) = -snapped(centre.x(), texel) * 2.0 / width;
    view.clip_from_world(1, 3) = -snapped(centre.y(), texel) * 2.0 / width;
    view.clip_from_world(2, 3) = snapped(centre.z(), texel) / width;

    Eigen::Matrix4d map_from_clip = 0.5 * Eigen::Matrix4d::Identity();
    map_from_clip.block<3, 1>(0, 3).setConstant(0.5);
    map_from_clip(3, 3) = 1.0;
    view.map_from_world = map_from_clip * view.clip_from_world;
    if (!casters.empty()) {
        for (int k = 0; k < 2; ++k) {
            const Eigen::Vector3d axis = view.map_from_world.block<1, 3>(k, 0).transpose();
            view.lowest[k] = view.map_from_world(k, 3) - casters.extent(-axis);
            view.highest[k] = view.map_from_world(k, 3) + casters.extent(axis);
        }
    }
    return view;
}

std::optional<Parallelogram> shadow_on_plane(
    const ShadowView& shadow, double border, const Vector3d& point, const Vector3d& normal) {
    const Eigen::Affine3d world_from_map = Eigen::Affine3d(shadow.map_from_world).inverse();
    const Vector3d along_ray = world_from_map.linear().col(2);
    const double descent = normal.dot(along_ray);
    if (std::abs(descent) < kGrazing * along_ray.norm() * normal.norm()) { return std::nullopt; }
    const auto dropped = [&](const Vector3d& along) -> Vector3d {
        return along - along_ray * (normal.dot(along) / descent);
    };
    const Eigen::Vector2d middle = 0.5 * (shadow.lowest + shadow.highest);
    const Eigen::Vector2d half =
        0.5 * (shadow.highest - shadow.lowest) + Eigen::Vector2d::Constant(border + kTexelMargin);
    const Vector3d start = world_from_map * Vector3d(middle.x(), middle.y(), 0.0);
    return Parallelogram{
        point + dropped(start - point), dropped(world_from_map.linear().col(0) * half.x()),
        dropped(world_from_map.linear().col(1) * half.y())};
}

Bounds bounds_of(const Parallelogram& part) {
    Bounds bounds;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) { bounds.include(part.centre + x * part.u + y * part.v); }
    }
    return bounds;
}

}  // namespace jw::render
