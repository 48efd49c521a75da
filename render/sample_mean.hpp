#pragma once

#include "render/device_rect.hpp"
#include "render/gl_objects.hpp"

namespace jw::render {

/// Averages the samples of a multisampled texture by a program of ours: that of the driver, behind
/// glBlitFramebuffer, is not in the cache of Mesa's software renderer, which translates it for 30 ms at every
/// start. OpenGL 3.3 only.
class SampleMean {
public:
    /// True if there are several samples, and a driver of OpenGL 3.3.
    static bool is_possible(const GlFunctions& gl, int samples);

    SampleMean(const GlFunctions& gl, int width, int height, int samples);

    /// Multisampled texture that bodies are drawn into: the colour of their framebuffer.
    const GlTexture& texture() const { return texture_; }

    /// Draws the means of a part into the framebuffer that is bound, of the same size. Uses texture unit 0.
    void draw(const DeviceRect& part) const;

private:
    const GlFunctions& gl_;
    int width_, height_, samples_;
    GlProgram program_;
    GlVertexArray no_attributes_;  // a triangle made of gl_VertexID alone
    GlTexture texture_;
};

}  // namespace jw::render
