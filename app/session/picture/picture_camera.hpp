#pragma once

#include "app/session/picture/picture.hpp"

namespace jw {

/// Unit direction from the eye to the scene: as the lesson asks, or else such that depth shows and no joint
/// axis is seen end-on, which is across the plane of a planar mechanism and three-quarter otherwise.
Vec3 view_direction(const Story& story, const Vec3& up);

/// The camera of a story: as the lesson asks; the rest is chosen so that everything is as large as
/// possible.
/// @param viewport the part of the frame that the scene is drawn into
/// @param safe the part of it that bodies stay in
render::Camera camera_of(
    const Story& story, const PictureStyle& style, const render::Rect& viewport, const render::Rect& safe);

}  // namespace jw
