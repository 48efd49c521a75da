#pragma once

#include <string>
#include <vector>

#include "app/session/story.hpp"
#include "render/framing.hpp"
#include "render/scene.hpp"

/// The 3D part of a step's picture: bodies, joints, and the vectors of the joint that the step is about.
namespace jw {

/// A name that belongs to a point of the scene, in formula markup (labels.hpp).
struct Annotation {
    Vec3 at = Vec3::Zero();       ///< what it names: the tip of a vector, a point [m]
    Vec3 towards = Vec3::Zero();  ///< direction in which there is room for it, global; zero: anywhere
    std::string text;
    render::Colour colour;
    bool body_name = false;  ///< less important: left out where there is no room
};

struct Picture {
    render::Scene scene;
    std::vector<Annotation> annotations;
};

/// What all pictures of a story share, found once, so that nothing grows, shrinks or moves between frames.
struct PictureStyle {
    double unit = 1.0;  ///< size of the mechanism [m]: pins, arrows and default rods are in proportion to it
    render::Bounds bounds;  ///< everything that is ever in sight: one camera serves the whole story
    Vec3 up = Vec3::UnitZ();
    render::Ground ground;
};
PictureStyle picture_style(const Story& story);

Picture picture_of(const Story& story, const PictureStyle& style, int index);

}  // namespace jw
