#pragma once

#include "app/export/gltf.hpp"
#include "app/session/story/story.hpp"

namespace jw {

/// The mechanism of a story as a scene of bodies that move: a node for each body with its shapes and its
/// halves of joints, at the times of the lesson's motion as it plays on the screen. Without a motion, the
/// assembled mechanism at rest. The root turns the upward direction of the lesson into y, that of glTF.
gltf::Scene moving_scene_of(const Story& story);

}  // namespace jw
