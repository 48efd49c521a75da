#pragma once

#include <cmath>

#include "tests/support/scene_builder.hpp"

/// Mechanisms with loops, assembled as they are generated: what decides rank, in every mixture.
namespace jw::test {

/// Up to four moving bodies; a joint of any type and form from each to one before it, up to three more
/// between any two, and a driver now and then. Axes are parallel to one direction up to a tilt from 0 (planar
/// loops: repeated equations) over 1e-12 ... 1e-1 (nearly repeated) to any; lengths and vectors of all sizes.
inline Mechanism random_net(Random& random) {
    const auto count = [&](double most) { return static_cast<int>(random.number(0.0, most + 0.999)); };
    const auto any_power = [&](double most) { return std::pow(10.0, random.number(-most, most)); };
    const Vec3 common = random.direction();
    const double tilt =
        std::array{0.0, 1.0, std::pow(10.0, -random.number(1.0, 12.0))}[static_cast<std::size_t>(count(2.0))];
    const double size = count(1.0) == 0 ? 1.0 : any_power(2.0);
    SceneBuilder scene;
    const int bodies = 1 + count(3.0);
    const auto add_joint = [&](int i, int j) {
        const JointType& type = kJointTypes[static_cast<std::size_t>(count(kJointTypes.size() - 1.0))];
        const Vec3 axis = common + tilt * random.vector();
        if (type.has_distance()) {
            const Vec3 from = random.vector(size);
            scene.add_link(type.name, i, j, from, from + size * random.direction(), axis);
            return;
        }
        if (type.has_own_coordinate()) {
            scene.add_any_wheels(type.name, i, j, random.vector(size), axis, size);
            return;
        }
        Joint& joint = scene.add_joint(type.name, i, j, random.vector(size), axis);
        JointGeometry& g = joint.geometry;
        if (type.uses(Role::axes_perpendicular)) { g.s_j_local = scene.local(j, perpendicular_to(axis)); }
        g.s_i_local *= any_power(1.0);
        g.s_j_local *= any_power(1.0);
        g.alpha = random.number(0.1, 0.5);
        joint.parallel_form = static_cast<ParallelForm>(count(5.0));
    };
    for (int b = 1; b <= bodies; ++b) {
        scene.add_body("body " + std::to_string(b), random.vector(size));
        add_joint(count(b - 1.0), b);
    }
    for (int extra = count(3.0); extra > 0; --extra) {
        const int j = 1 + count(bodies - 1.0);
        add_joint(count(j - 1.0), j);
    }
    if (scene.mechanism.joints[0].type->name == "revolute" && count(1.0) == 0) {
        drive_angle(scene.mechanism, 0, polynomial({0.3, 1.0}));
    }
    return moved_rigidly(scene.mechanism, random.unit_p(), random.vector(size));
}

}  // namespace jw::test
