#include "render/gl/sample_mean.hpp"

#include "render/gl/shaders.hpp"

namespace jw::render {

bool SampleMean::is_possible(const GlFunctions& gl, int samples) {
    return samples > 1 && gl.profile == GlProfile::core_33;
}

SampleMean::SampleMean(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      samples_(samples),
      program_(gl, "mean of samples", shaders::backdrop_vertex(), shaders::sample_mean_fragment()),
      no_attributes_(make_vertex_array(gl)),
      texture_(make_texture(gl)) {
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture_.name());
    gl_.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, width, height, GL_TRUE);
}

void SampleMean::draw(const DeviceRect& part) const {
    if (part.empty()) { return; }
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(part.x, part.y, part.width, part.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture_.name());
    program_.use();
    program_.set("picture", 0);
    program_.set("samples", samples_);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindVertexArray(0);
    gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace jw::render
