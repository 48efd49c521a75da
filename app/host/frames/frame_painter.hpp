#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/frame_size.hpp"
#include "render/gl_functions.hpp"
#include "render/image.hpp"
#include "render/palette.hpp"
#include "render/picture_layers.hpp"
#include "render/vector_picture.hpp"

namespace jw::host {

/// Look of frames, beside what they show.
struct FrameLook {
    render::Tone tone = render::Tone::light;
    double text = 1.0;       ///< size of text beside the usual one
    bool has_panels = true;  ///< false: the 3D picture and its names alone
    bool is_opaque = true;   ///< false: what is behind bodies and names shines through; without panels only
    /// Largest width of what is drawn at once [pixels], which has no more pixels than one of this width and
    /// 9/16 of it in height. Larger frames are drawn tile by tile, in less memory.
    int tile_width = 4096;

    /// Size of letters in a frame, 1 as at 1280x720.
    float scale(int width, int height) const;
};

/// Parts of painting a frame, in their order.
enum class PaintStage { shadow, scene, panels, read };
/// Told when each of them has ended, for those who measure: then, and only then, each is waited for.
using OnPaintStage = std::function<void(PaintStage)>;

/// Draws steps of one story into memory, panels included. The camera is composed once, so that nothing jumps
/// from frame to frame; a frame depends on its step alone, not on the frames drawn before.
class FramePainter {
public:
    /// `story` must outlive this. Width and height in pixels. Fonts are read in a thread, until the first
    /// panels are drawn.
    /// @throws std::runtime_error if OSMesa is missing; the first picture does if a font is
    FramePainter(const Story& story, int width, int height, const FrameLook& look = {});
    /// Paints in an existing context, which must be current here, in `paint` and at destruction.
    FramePainter(const Story& story, int width, int height, const render::GlFunctions& gl);
    ~FramePainter();
    FramePainter(const FramePainter&) = delete;
    FramePainter& operator=(const FramePainter&) = delete;

    /// Waits for the fonts, for those who write something before the first picture.
    /// @throws std::runtime_error if one is missing
    void wait_for_fonts();

    render::Image paint(const View& view);

    const render::Camera& camera() const;
    /// Picture that `paint` draws in 3D, for those who look at it or change it before it is drawn.
    Picture picture(const View& view) const;
    /// Picture of a step in the place of that of the view: its bodies may be elsewhere.
    Picture picture(const View& view, const Step& step) const;
    /// Paints another 3D part than that of the step.
    render::Image paint(const View& view, const Picture& picture, const OnPaintStage& ended = {});
    /// Paints the step as one of another number among others: `step` counts from 0, as in the view.
    render::Image paint_numbered(View view, const Picture& picture, int step, int steps);
    /// The frame as a file of lines, areas and letters; its 3D part is a picture of twice as many pixels.
    std::vector<std::uint8_t> vector_file(const View& view, render::VectorFormat format);
    /// Name of the renderer, with the versions of OpenGL and Mesa.
    std::string renderer() const;
    /// Things seen at each pixel of the 3D part, and their depth.
    render::PictureLayers layers(const Picture& picture);

private:
    struct Surface;
    void compose_camera();
    void draw_scene(const Picture& picture);
    void lay_out_panels(const View& view, const Picture& picture, const Emphasis& lit);
    render::Image paint(
        const View& view, const Picture& picture, const Emphasis& lit, const OnPaintStage& ended);
    Emphasis lit_at(const View& view) const;

    const Story* story_;
    FrameLook look_;
    PictureStyle style_;
    std::unique_ptr<Surface> surface_;
};

}  // namespace jw::host
