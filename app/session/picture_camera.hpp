#pragma once

#include "app/session/picture.hpp"

namespace jw {

/// The camera of a story: what the lesson asks for, and for the rest a view in which the mechanism is large
/// and its depth shows: across the plane of a planar mechanism, three-quarter otherwise.
/// @param viewport the part of the frame that the scene is drawn into, `safe` the part of it that bodies stay
/// in
render::Camera camera_of(
    const Story& story, const PictureStyle& style, const render::Rect& viewport, const render::Rect& safe);

}  // namespace jw
