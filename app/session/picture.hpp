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

/// Sizes of things that have none in the lesson (pins, arrows, default rods): once per story, so that nothing
/// grows or shrinks between frames.
struct PictureStyle {
    double unit = 1.0;  ///< typical length of the mechanism [m]
};
PictureStyle picture_style(const Story& story);

Picture picture_of(const Story& story, const PictureStyle& style, int index);

/// Everything that is ever in sight: one camera serves the whole story.
render::Bounds bounds_of(const Story& story, const PictureStyle& style);

}  // namespace jw
