#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/files/image.hpp"
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

/// Framebuffers for one size of picture in the current context. The window and `Offscreen` draw into the same
/// ones, so both show the same pixels, and `read` makes a screenshot.
///
/// One frame is `begin_3d`, `SceneRenderer::draw`, `begin_2d`, draw panels, then `read` or `blit_to_window`.
/// Only bodies are multisampled, and only where there are some: the backdrop has no edges, and text is as
/// sharp without multisampling. A frame in which no body has moved may start with `begin_2d`: the bodies stay
/// as they were drawn. For another size, make a new object.
class RenderTargets {
public:
    /// The context must be current here, in every call and at destruction; `gl` must outlive this object.
    /// @param samples  wanted per pixel: 1 is fast, for moving pictures. If more than 1 are wanted and the
    /// driver has no multisampling, the picture is drawn at double size instead.
    /// @throws std::runtime_error if the size is out of the driver's range.
    RenderTargets(const GlFunctions& gl, int width, int height, int samples = 4);

    /// The whole frame that is drawn.
    FrameSize size() const { return size_; }

    /// Part of the frame that is drawn; it is as large as the buffers.
    const FramePart& part() const { return part_; }

    /// From now on, draws a part of a larger frame; it begins at a corner and is as large as the buffers.
    /// @throws std::runtime_error if the frame is larger than the driver's viewports
    void show_part(int x, int y, int frame_width, int frame_height);

    /// Samples per pixel that are used; 1 if drawn at double size.
    int samples() const { return samples_; }

    /// Binds the framebuffer for scenes, which is cleared.
    /// @param paper  the colour of the picture where nothing is drawn
    void begin_3d(const Colour& paper = palette::kPaper);

    /// Colour of the last `begin_3d`.
    const Colour& paper() const { return paper_; }

    /// Binds the multisampled framebuffer for bodies, which has a depth buffer; its old content is not
    /// cleared.
    void begin_bodies() const;

    /// Copies a part of that framebuffer into the one for scenes, and binds the latter.
    void end_bodies(const DeviceRect& part) const;

    /// Binds the flat framebuffer for panels and text, with the last scene in it.
    void begin_2d() const;

    /// The picture, top row first.
    /// @param is_opaque  false: with its alpha, if the paper of `begin_3d` is transparent black
    /// @throws std::runtime_error if GL reported an error since the last call.
    Image read(bool is_opaque = true);

    /// Copies the picture to the lower left corner of the context's own framebuffer, which must not be
    /// multisampled and stays bound.
    void blit_to_window() const;

private:
    /// A framebuffer with colour and, if needed, depth.
    struct Target {
        GlFramebuffer framebuffer;
        GlRenderbuffer colour;
        GlRenderbuffer depth;
    };
    enum class Depth : bool { without, with };

    Target make_target(int samples, Depth depth) const;
    GLsizei device_width() const { return part_.width * size_.pixel_ratio; }
    GLsizei device_height() const { return part_.height * size_.pixel_ratio; }

    const GlFunctions& gl_;
    int samples_;
    FrameSize size_;
    FramePart part_;
    std::optional<SampleMean> mean_;  // of the bodies; nothing: the driver averages, or there is one sample
    Target bodies_;
    Target scene_;
    Target flat_;
    Colour paper_ = palette::kPaper;
    std::vector<std::uint8_t> rgba_;  // of the device
};

}  // namespace jw::render
