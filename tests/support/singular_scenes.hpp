#pragma once

#include "tests/support/scenes.hpp"

/// Structures at poses where equations that are otherwise independent repeat each other.
namespace jw::test {

/// Two bars of length 1 in line between bearings 2 apart: they cannot move, but their middle hinge has a
/// velocity across the line. The joints make no row redundant.
inline Mechanism stretched_bars() {
    SceneBuilder scene;
    const int left = scene.add_body("left", Vec3(0.5, 0.0, 0.0));
    const int right = scene.add_body("right", Vec3(1.5, 0.0, 0.0));
    const Vec3 z = Vec3::UnitZ();
    scene.add_joint("revolute", 0, left, Vec3::Zero(), z);
    scene.add_joint("cylindrical", left, right, Vec3(1.0, 0.0, 0.0), z);
    scene.add_joint("spherical", 0, right, Vec3(2.0, 0.0, 0.0), z);
    return scene.mechanism;
}

/// The same of revolutes: three rows are redundant besides.
inline Mechanism stretched_revolutes() {
    Mechanism mechanism = stretched_bars();
    for (Joint& joint : mechanism.joints) { joint.type = find_joint_type("revolute"); }
    return mechanism;
}

}  // namespace jw::test
