#include "render/passes/shadow_map.hpp"

#include "render/gl/shaders.hpp"

namespace jw::render {
namespace {

GlTexture make_map(const GlFunctions& gl) {
    GlTexture map = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, map.name());
    gl.TexImage2D(
        GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, ShadowMap::kTexels, ShadowMap::kTexels, 0, GL_DEPTH_COMPONENT,
        GL_UNSIGNED_INT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // everything outside the map is lit, like its border, which no shadow reaches (shadow_view.cpp: kMargin)
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return map;
}

/// The framebuffer that was bound stays bound.
GlFramebuffer make_framebuffer_of(const GlFunctions& gl, const GlTexture& map) {
    GlFramebuffer framebuffer = make_framebuffer(gl);
    const BoundFramebuffer bound(gl, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.name(), 0);
    constexpr GLenum no_colour = GL_NONE;
    gl.DrawBuffers(1, &no_colour);
    gl.ReadBuffer(GL_NONE);
    return framebuffer;
}

}  // namespace

ShadowMap::ShadowMap(const GlFunctions& gl)
    : gl_(gl),
      depth_(gl, "depth", shaders::body_vertex(), shaders::depth_fragment()),
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

}  // namespace jw::render
