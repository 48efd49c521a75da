#pragma once

#include "app/session/picture/picture.hpp"

namespace jw {

/// Direction from the eye to the scene: what the lesson asks for, else one in which depth shows and no joint
/// axis is seen end-on: across the plane of a planar mechanism, three-quarter otherwise. Unit.
Vec3 view_direction(const Story& story, const Vec3& up);

/// The camera of a story: what the lesson asks for; the rest is chosen so that everything is as large as
/// possible.
/// @param viewport the part of the frame that the scene is drawn into
/// @param safe the part of it that bodies stay in
render::Camera camera_of(
    const Story& story, const PictureStyle& style, const render::Rect& viewport, const render::Rect& safe);

}  // namespace jw
