#pragma once

#include "app/panels/parts/canvas.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/fonts/fonts.hpp"
#include "render/scene/camera.hpp"

/// A whole frame: title, the 3D picture with its labels, caption, and the column of panels.
namespace jw::panels {

/// The parts of a frame. They depend only on its size, so nothing moves from step to step.
///
/// A frame that is clearly higher than wide is upright: its parts are as wide as the frame, and one below the
/// other in the order in which they are listed here. In any other frame, the column is at the right, with
/// tabs above it.
struct FrameLayout {
    bool upright = false;
    bool for_fingers = false;  ///< larger controls: upright, or a phone that is turned
    Box title;
    render::Rect scene;       ///< 3D viewport
    render::Rect scene_safe;  ///< part of it for bodies, with room for labels around
    Box caption;              ///< below the scene
    Box tabs;                 ///< above the column; height 0 in pictures
    Box column;               ///< of panels
    Box bar;                  ///< of the timeline, at the foot; height 0 in pictures
};

enum class FrameKind { picture, window };

/// Size of text for a frame: 1 at 1280x720, and for upright frames 1 at 480x800. The smaller of the ratios of
/// width and height counts.
float scale_of(int width, int height);

/// A screen, and the size of text that the user wants on it.
struct Looking {
    /// Pixels of the screen per pixel of a web page (a phone is about 400 of those wide); 0: not known.
    float density = 0.0F;
    float text = 1.0F;  ///< relative to the usual one
};

/// Size of text for a frame on a screen. If the density is known, letters are large enough for a screen in
/// the hand; in an upright frame they are not larger than those of web pages, and never so large that panels
/// have no room.
float scale_on_screen(int width, int height, const Looking& looking);

FrameLayout layout_of(int width, int height);

/// Size of text for a frame with only the 3D picture: relative to the mechanism, names are as large as with
/// panels.
float scale_without_panels(int width, int height);

/// Layout of a frame with only the 3D picture.
FrameLayout layout_without_panels(const Box& frame, float scale);

/// Layout of a frame whose size of text is not that of scale_of.
/// @param scale  of text; the caption grows with it
/// @param density  see Looking: in an upright window, controls are as high as a finger needs
FrameLayout layout_in(const Box& frame, FrameKind kind, float scale, float density = 0.0F);

/// Draws everything but the 3D picture itself.
/// @param canvas  with fonts loaded for scale_of(width, height)
void draw_frame(
    const Canvas& canvas, const View& view, const Picture& picture, const render::Camera& camera,
    const FrameLayout& layout);

/// Draws lesson, step, source, number of the step and time; the line below shows the progress of the story.
void draw_title(const Canvas& canvas, const Box& box, const View& view);

/// Draws what happened in the step, and the author's text about it.
void draw_caption(const Canvas& canvas, const Box& box, const View& view);

/// Height that a caption of this width needs to show every sentence, `box.height` if that is enough.
float caption_height(const Canvas& canvas, const Box& box, const View& view);

}  // namespace jw::panels
