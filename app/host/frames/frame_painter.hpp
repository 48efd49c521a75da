#pragma once

#include <memory>
#include <string>

#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/gl_functions.hpp"
#include "render/image.hpp"
#include "render/picture_layers.hpp"
#include "render/vector_picture.hpp"

namespace jw::host {

/// Draws steps of one story into memory, panels included. The camera is composed once, so that nothing jumps
/// from frame to frame; a frame depends on its step alone, not on the frames drawn before.
class FramePainter {
public:
    /// `story` must outlive this. Width and height in pixels.
    /// @throws std::runtime_error if OSMesa or a font is missing
    FramePainter(const Story& story, int width, int height);
    /// Paints in an existing context, which must be current here, in `paint` and at destruction.
    FramePainter(const Story& story, int width, int height, const render::GlFunctions& gl);
    ~FramePainter();
    FramePainter(const FramePainter&) = delete;
    FramePainter& operator=(const FramePainter&) = delete;

    render::Image paint(const View& view);

    const render::Camera& camera() const;
    /// What `paint` draws in 3D, for those who look at it or change it before it is drawn.
    Picture picture(const View& view) const;
    /// Paints another 3D part than that of the step.
    render::Image paint(const View& view, const Picture& picture);
    /// The frame as a file of lines, areas and letters; its 3D part is a picture of twice as many pixels.
    std::vector<std::uint8_t> vector_file(const View& view, render::VectorFormat format);
    /// What draws: renderer, OpenGL and Mesa with their versions.
    std::string renderer() const;
    /// What is seen at each pixel of the 3D part.
    render::PictureLayers layers(const Picture& picture);

private:
    struct Surface;
    void compose_camera();
    Emphasis lit_at(const View& view) const;

    const Story* story_;
    PictureStyle style_;
    std::unique_ptr<Surface> surface_;
};

}  // namespace jw::host
