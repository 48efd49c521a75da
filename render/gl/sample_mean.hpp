#pragma once

#include "render/gl/device_rect.hpp"
#include "render/gl/gl_objects.hpp"

namespace jw::render {

/// Averages the samples of a multisampled texture with its own shaders. Mesa's software renderer does not
/// cache the shaders that the driver uses for glBlitFramebuffer, and compiles them for 30 ms at every start.
/// OpenGL 3.3 only.
class SampleMean {
public:
    /// True if there are several samples and the driver has OpenGL 3.3.
    static bool is_possible(const GlFunctions& gl, int samples);

    SampleMean(const GlFunctions& gl, int width, int height, int samples);

    /// Multisampled texture that bodies are drawn into: the colour attachment of their framebuffer.
    const GlTexture& texture() const { return texture_; }

    /// Draws the means of a part into the bound framebuffer, of the same size. Uses texture unit 0.
    void draw(const DeviceRect& part) const;

private:
    const GlFunctions& gl_;
    int width_, height_, samples_;
    GlProgram program_;
    GlVertexArray no_attributes_;  // a triangle computed from gl_VertexID alone
    GlTexture texture_;
};

}  // namespace jw::render
