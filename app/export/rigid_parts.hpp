#pragma once

#include <string>
#include <vector>

#include "app/session/picture/picture.hpp"

/// Parts of a moving picture, and the body that each is fixed in.
namespace jw {

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
