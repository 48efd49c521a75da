#pragma once

#include "app/session/picture.hpp"

/// Parts that picture.cpp puts together; used by it and its tests only.
namespace jw::picture {

/// A body's frame at a state.
struct BodyFrame {
    Mat3 A = Mat3::Identity();
    Vec3 r = Vec3::Zero();

    Vec3 point(const Vec3& s_local) const { return r + A * s_local; }
    Vec3 direction(const Vec3& s_local) const { return (A * s_local).normalized(); }
};
BodyFrame frame_of(const State& state, int body);

/// A joint's vectors at a state, global; directions unit.
struct PlacedJoint {
    const Joint* joint = nullptr;
    Vec3 P_i, P_j;
    Vec3 s_i, s_j;
    Vec3 h_i, h_j;
    Vec3 u_i, u_j;
};
PlacedJoint placed(const Joint& joint, const State& state);

/// Radius of a pin; other sizes are multiples of it.
inline double pin_radius(const PictureStyle& style) { return 0.011 * style.unit; }

render::Colour colour_of_body(const Lesson& lesson, int body);

/// Shapes of the lesson, or rods between the joints of a body that has none.
void add_body(
    const Lesson& lesson, const PictureStyle& style, const State& state, int body, render::Scene& scene);
/// Where a body's name may stand [m].
Vec3 middle_of_body(const Lesson& lesson, const State& state, int body);

/// What a joint looks like; its two halves apart where it is not assembled.
void add_joint(
    const Lesson& lesson, const PictureStyle& style, const PlacedJoint& joint, bool highlighted,
    render::Scene& scene);

/// Points and vectors of the joint that the step is about, with their names.
void add_vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture);
/// What a driver prescribes: an angle as an arc, a distance as an arrow.
void add_driver(
    const Lesson& lesson, const PictureStyle& style, const State& state, int driver, Picture& picture);

}  // namespace jw::picture
