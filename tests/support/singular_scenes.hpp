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

/// Stretched bars with revolute joints: three more rows are redundant.
inline Mechanism stretched_revolutes() {
    Mechanism mechanism = stretched_bars();
    for (Joint& joint : mechanism.joints) { joint.type = find_joint_type("revolute"); }
    return mechanism;
}

/// A plate in the plane z = 0 on three rods of which the upper ends are on the plate and the lower ones on
/// ground: it has one null vector where the rods' lines meet in a point or are parallel.
inline Mechanism plate_on_rods(const std::array<Vec3, 3>& ground, const std::array<Vec3, 3>& plate) {
    SceneBuilder scene;
    const int body = scene.add_body("plate", Vec3::Zero());
    scene.add_joint("planar", 0, body, Vec3::Zero(), Vec3::UnitZ());
    for (std::size_t k = 0; k < 3; ++k) { scene.add_distance(0, body, ground[k], plate[k]); }
    return scene.mechanism;
}

}  // namespace jw::test
