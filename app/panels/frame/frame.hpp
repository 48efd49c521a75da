#pragma once

#include "app/panels/parts/canvas.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "render/camera.hpp"
#include "render/fonts.hpp"

/// A whole frame: title, the 3D picture with its labels, caption, and the column of panels.
namespace jw::panels {

/// The parts of a frame. They depend on nothing but its size, so nothing moves from step to step.
struct FrameLayout {
    render::Rect scene;       ///< 3D viewport
    render::Rect scene_safe;  ///< part of it that bodies should keep to: labels find room around
    Box title;
    Box caption;  ///< below the scene
    Box tabs;     ///< above the column; of no height in pictures
    Box column;   ///< of panels, right
};

/// Sizes of text for a frame: 1 at 1280x720.
float scale_of(int width, int height);

FrameLayout layout_of(int width, int height);

/// Sizes of text for a frame that is the 3D picture alone: names are as large beside the mechanism as with
/// panels.
float scale_without_panels(int width, int height);

/// Layout of a frame that is the 3D picture alone.
FrameLayout layout_without_panels(const Box& frame, float scale);

/// Layout of a frame in a part of a window.
/// @param scale  of text, see scale_of
/// @param tabs_height  left free above the column of panels
/// @param text  size of text beside that of a frame of this size: the caption grows with it
FrameLayout layout_in(const Box& frame, float scale, float tabs_height, float text = 1.0F);

/// Draws everything but the 3D picture itself.
/// @param canvas  with fonts loaded for scale_of(width, height)
void draw_frame(
    const Canvas& canvas, const View& view, const Picture& picture, const render::Camera& camera,
    const FrameLayout& layout);

}  // namespace jw::panels
