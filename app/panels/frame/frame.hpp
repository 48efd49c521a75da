#pragma once

#include "app/panels/parts/canvas.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/camera.hpp"
#include "render/fonts.hpp"

/// A whole frame: title, the 3D picture with its labels, caption, and the column of panels.
namespace jw::panels {

/// The parts of a frame. They depend on nothing but its size, so nothing moves from step to step.
///
/// A frame that is clearly higher than wide stands upright: its parts are as wide as the frame and below each
/// other, in the order in which they are listed here. Any other has the column, with tabs above it, at the
/// right.
struct FrameLayout {
    bool upright = false;
    bool for_fingers = false;  ///< what is pressed is larger: upright, or a phone that is turned
    Box title;
    render::Rect scene;       ///< 3D viewport
    render::Rect scene_safe;  ///< part of it that bodies should keep to: labels find room around
    Box caption;              ///< below the scene
    Box tabs;                 ///< above the column; of no height in pictures
    Box column;               ///< of panels
    Box bar;                  ///< of the timeline, at the foot; of no height in pictures
};

enum class FrameKind { picture, window };

/// Sizes of text for a frame: 1 at 1280x720, and at 480x800, of which an upright frame has the width or the
/// height.
float scale_of(int width, int height);

/// A screen, and the size of text that somebody asks for on it.
struct Looking {
    /// Pixels for one of a web page, of which a phone has about 400 in its width; 0: not known.
    float density = 0.0F;
    float text = 1.0F;  ///< beside the usual one
};

/// Sizes of text for a frame on a screen. Where its density is known, letters are as large as a hand needs
/// them, in an upright frame no larger than those of pages, and never so large that panels have no room.
float scale_on_screen(int width, int height, const Looking& looking);

FrameLayout layout_of(int width, int height);

/// Sizes of text for a frame that is the 3D picture alone: names are as large beside the mechanism as with
/// panels.
float scale_without_panels(int width, int height);

/// Layout of a frame that is the 3D picture alone.
FrameLayout layout_without_panels(const Box& frame, float scale);

/// Layout of a frame with letters of another size than scale_of.
/// @param scale  of text; the caption grows with it
/// @param density  see Looking: in an upright window what is pressed is as high as a finger needs
FrameLayout layout_in(const Box& frame, FrameKind kind, float scale, float density = 0.0F);

/// Draws everything but the 3D picture itself.
/// @param canvas  with fonts loaded for scale_of(width, height)
void draw_frame(
    const Canvas& canvas, const View& view, const Picture& picture, const render::Camera& camera,
    const FrameLayout& layout);

}  // namespace jw::panels
