#pragma once

#include "tests/reference/scene.hpp"

/// Parts that scenes are built of.
namespace jw::reference {

inline Scene scene_named(const char* name, const char* what, const Vec3& gravity, Real duration) {
    Scene scene;
    scene.name = name;
    scene.what = what;
    scene.gravity = gravity;
    scene.duration = duration;
    return scene;
}

inline int add(Scene& scene, const Body& body) {
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
}

/// Adds a joint that brings body j along.
inline void hinge(
    Scene& scene, JointKind kind, int i, int j, const Vec3& point, const Vec3& axis = Vec3::UnitZ()) {
    scene.joints.push_back({kind, i, j, point, axis});
}

/// Adds a revolute joint between two bodies that are already in the scene.
inline void close(Scene& scene, int i, int j, const Vec3& point, const Vec3& axis = Vec3::UnitZ()) {
    scene.joints.push_back({JointKind::revolute, i, j, point, axis});
    scene.joints.back().closes_loop = true;
}

/// Rod from a to b, x along it, with moments about its length and across it.
inline Body rod(const Vec3& a, const Vec3& b, Real mass, Real J_along, Real J_across) {
    Body body;
    body.mass = mass;
    body.J = Vec3(J_along, J_across, J_across);
    body.r = (a + b) / 2.0L;
    body.p = x_axis_to(b - a);
    return body;
}

/// Sets the velocity of a body that turns about an axis through `point`.
inline void spin(Body& body, const Vec3& omega, const Vec3& point) {
    body.omega = omega;
    body.v = omega.cross(body.r - point);
}

}  // namespace jw::reference
