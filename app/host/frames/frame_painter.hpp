#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/files/image.hpp"
#include "render/files/vector_picture.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/palette.hpp"
#include "render/scene/picture_layers.hpp"

namespace jw::host {

/// Look of frames, apart from their content.
struct FrameLook {
    render::Tone tone = render::Tone::light;
    double text = 1.0;       ///< size of text relative to the usual one
    bool has_panels = true;  ///< false: only the 3D picture and its names
    bool is_opaque = true;   ///< false: the background is transparent; only without panels
    /// Largest width of a tile [pixels]; a tile has at most the pixels of a 16:9 picture of this width.
    /// Larger frames are drawn tile by tile, to save memory.
    int tile_width = 4096;

    /// Size of text in a frame; 1 is the size at 1280x720.
    float scale(int width, int height) const;
};

/// Stages of painting a frame, in order.
enum class PaintStage { shadow, scene, panels, read };
/// Called at the end of each stage, for measurements. Painting waits for each stage only if this is given.
using OnPaintStage = std::function<void(PaintStage)>;

/// Draws steps of one story into memory, with panels. The camera is chosen once, so that nothing jumps from
/// frame to frame. A frame depends only on its step, not on the frames drawn before.
class FramePainter {
public:
    /// `story` must outlive this. Width and height in pixels. Fonts are loaded in a thread; the first panels
    /// wait for it.
    /// @throws std::runtime_error if OSMesa is missing. If a font is missing, the first `paint` throws it
    FramePainter(const Story& story, int width, int height, const FrameLook& look = {});
    /// Paints in an existing context, which must be current here, in `paint` and at destruction.
    FramePainter(const Story& story, int width, int height, const render::GlFunctions& gl);
    ~FramePainter();
    FramePainter(const FramePainter&) = delete;
    FramePainter& operator=(const FramePainter&) = delete;

    /// Waits for the fonts, for callers that write something before the first picture.
    /// @throws std::runtime_error if a font is missing
    void wait_for_fonts();

    render::Image paint(const View& view);

    const render::Camera& camera() const;
    /// The 3D picture that `paint` draws, for callers that inspect or change it first.
    Picture picture(const View& view) const;
    /// Picture of `step` instead of the view's step: its bodies may have another pose.
    Picture picture(const View& view, const Step& step) const;
    /// Paints `picture` instead of the 3D picture of the step.
    render::Image paint(const View& view, const Picture& picture, const OnPaintStage& ended = {});
    /// Paints the step as number `step` of `steps`; `step` counts from 0, as in the view.
    render::Image paint_numbered(View view, const Picture& picture, int step, int steps);
    /// The frame as a vector file; its 3D part is an image of twice the resolution.
    std::vector<std::uint8_t> vector_file(const View& view, render::VectorFormat format);
    /// Name of the renderer, with the versions of OpenGL and Mesa.
    std::string renderer() const;
    /// The object at each pixel of the 3D part, and its depth.
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
