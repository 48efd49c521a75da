#pragma once

#include "app/export/gltf.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/story/story.hpp"

namespace jw {

/// The mechanism of a story as a scene of bodies that move: a node for each body with its shapes and its
/// halves of joints, at the times of the lesson's motion as it plays on the screen. Without a motion, the
/// assembled mechanism at rest. The root turns the upward direction of the lesson into y, that of glTF.
gltf::Scene moving_scene_of(const Story& story);

/// A solid that moves with a body.
struct RigidPart {
    int body = 0;
    std::string name;     ///< "crank · shape 1", "hinge · shape 2"
    render::Shape shape;  ///< in the body frame
};

/// The solids in the pictures of some steps (shapes of bodies, and halves of joints), each with the body that
/// it is fixed in. The body is found from the places of the solid at all steps. A solid that is fixed in no
/// body, such as a spring, is left out, and so are vectors and lines.
/// @param steps  indices into the story; at least one
std::vector<RigidPart> rigid_parts_of(
    const Story& story, const PictureStyle& style, const std::vector<int>& steps);

}  // namespace jw
