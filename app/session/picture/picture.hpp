#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/session/picture/pointable.hpp"
#include "app/session/story/story.hpp"
#include "render/scene/framing.hpp"
#include "render/scene/scene.hpp"

/// The 3D part of a step's picture: bodies, joints, and the vectors of the joint that the step is about.
namespace jw {

/// A name at a point of the scene; its formulas are written as docs/mathematics.md says.
struct Annotation {
    Vec3 at = Vec3::Zero();       ///< place of the named thing: the tip of a vector, a point [m]
    Vec3 towards = Vec3::Zero();  ///< direction in which there is room for it, global; zero: anywhere
    std::string text;
    render::Colour colour;
    bool body_name = false;  ///< less important: left out if there is no room
    Pointable link = {};     ///< the thing that it names
};

struct Picture {
    render::Scene scene;
    std::vector<Annotation> annotations;
};

/// Teeth of the two wheels of a joint. A wheel that meshes with several others has the same teeth in all of
/// its joints.
struct WheelStyle {
    int teeth_i = 0;
    int teeth_j = 0;
    double offset_i = 0.0;  ///< of a tooth from where the wheels meet at θ = 0, in teeth
    double offset_j = 0.5;
};

/// Lengths of a joint's glyph and vectors that are the same in all pictures [m].
struct JointStyle {
    double aside_i = 0.0;  ///< from the line of s_i to where s_i is visible beside the bodies
    double aside_j = 0.0;  ///< the same for s_j
    double side = 0.0;     ///< from the point P along h and u to the surface of the bodies
    double lift_i = 0.0;   ///< along the axis to where h_i (u_i of a screw) is visible
    double lift_j = 0.0;   ///< the same for h_j (u_j)
    double lowest = 0.0;  ///< smallest s_iᵀ d (θ on a curve) over the story, at most 0: the bar reaches P_i
    double highest = 0.0;
    double farthest = 0.0;  ///< largest distance of P_j from the line of s_i [m]
    WheelStyle wheels;      ///< of gears and racks
};

/// Properties that all pictures of a story share, found once, so that nothing grows, shrinks or jumps between
/// frames.
struct PictureStyle {
    double unit = 1.0;  ///< size of the mechanism [m]: pins, arrows and default rods are in proportion to it
    Vec3 up = Vec3::UnitZ();
    Vec3 view{-0.62, 0.66, -0.42};           ///< from the eye to the scene
    std::vector<std::vector<Shape>> bodies;  ///< shapes of each body, in its frame; see local_shapes
    std::vector<JointStyle> joints;
    int traced_body = -1;  ///< body whose point draws its path during the motion; -1: nothing moves
    Vec3 traced_point_local = Vec3::Zero();
    bool ground_axes = true;  ///< false: they are too far away to be shown
    render::Bounds bounds;    ///< everything that is ever visible: one camera serves the whole story
    render::Ground ground;
    double newton = 0.0;        ///< length of an arrow for 1 N; 0: there are no forces
    double newton_metre = 0.0;  ///< and for 1 N m
};
/// Style of a story that has kept its steps.
PictureStyle picture_style(const Story& story);

/// @param index of the step in the story
Picture picture_of(const Story& story, const PictureStyle& style, int index);

/// Highlights the bodies, joints and vectors in `lit`.
void light_up(Picture& picture, const Emphasis& lit);

/// Adds other poses of the same bodies in pale colours, the later ones stronger.
void add_ghosts(
    const Lesson& lesson, const PictureStyle& style, std::span<const State> poses, Picture& picture);

/// Picture of a step that takes the place of step `index` of the story, such as a pose moved by hand.
Picture picture_of(const Story& story, const PictureStyle& style, const Step& step, int index);

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
