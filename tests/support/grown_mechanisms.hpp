#pragma once

#include <array>
#include <cmath>

#include "tests/support/scene_builder.hpp"

/// Mechanisms of any number of bodies, assembled at their start pose.
namespace jw::test {

/// n rods of 1 m in a row along x, hinged with parallel axes, the first one to ground.
inline Mechanism hinge_chain(int n) {
    SceneBuilder scene;
    int last = 0;
    for (int k = 0; k < n; ++k) {
        const int rod = scene.add_body("rod " + std::to_string(k), Vec3(k + 0.5, 0.0, 0.0));
        scene.add_joint("revolute", last, rod, Vec3(k, 0.0, 0.0), -Vec3::UnitY());
        last = rod;
    }
    return std::move(scene.mechanism);
}

/// n + 1 posts side by side and n rungs on their ends: n parallelograms, each with three redundant equations.
/// The first joint is the first post's hinge.
inline Mechanism parallelogram_ladder(int n) {
    SceneBuilder scene;
    const Vec3 axis = -Vec3::UnitY();
    std::vector<int> posts;
    for (int k = 0; k <= n; ++k) {
        posts.push_back(scene.add_body("post " + std::to_string(k), Vec3(k, 0.0, 0.5)));
        scene.add_joint("revolute", 0, posts.back(), Vec3(k, 0.0, 0.0), axis);
    }
    for (int k = 0; k < n; ++k) {
        const int rung = scene.add_body("rung " + std::to_string(k), Vec3(k + 0.5, 0.0, 1.0));
        scene.add_joint("revolute", posts[at(k)], rung, Vec3(k, 0.0, 1.0), axis);
        scene.add_joint("revolute", rung, posts[at(k) + 1], Vec3(k + 1.0, 0.0, 1.0), axis);
    }
    return std::move(scene.mechanism);
}

/// A joint of any type that fits at a point and an axis.
inline void add_any_joint(
    SceneBuilder& scene, Random& random, int i, int j, const Vec3& point, const Vec3& axis) {
    constexpr std::array types{"revolute",  "revolute", "spherical", "prismatic", "cylindrical",
                               "universal", "screw",    "planar",    "fixed",     "distance"};
    const char* type = types[static_cast<std::size_t>(random.number(0.0, types.size() - 1e-9))];
    if (type == std::string_view("universal")) {
        scene.add_universal(i, j, point, axis, perpendicular_to(axis));
    } else if (type == std::string_view("distance")) {
        scene.add_distance(i, j, point, point + random.vector() + Vec3(1.2, 0.0, 0.0));
    } else {
        Joint& joint = scene.add_joint(type, i, j, point, axis);
        joint.geometry.alpha = random.number(0.1, 0.3);
        if (random.number() < -0.6) { joint.parallel_form = ParallelForm::all_three; }
        if (random.number() < -0.6) { joint.parallel_form = ParallelForm::pair; }
    }
}

/// A tree of `bodies` bodies with joints of every type, and `loops` more joints: between any two bodies, a
/// second time where one is already, or a closing hinge with the axis of others, so that equations repeat
/// others. Angle drivers on some.
inline Mechanism grown_mechanism(unsigned seed, int bodies, int loops) {
    Random random(seed);
    SceneBuilder scene;
    const Vec3 common_axis = random.direction();
    const auto axis = [&] { return random.number() < 0.0 ? common_axis : random.direction(); };
    const auto any_of = [&](int count) { return static_cast<int>(random.number(0.0, count - 1e-9)); };
    for (int k = 0; k < bodies; ++k) {
        const int body = scene.add_body("body " + std::to_string(k), random.vector(2.0));
        const int parent = random.number() < 0.4 ? body - 1 : any_of(body);
        add_any_joint(scene, random, parent, body, random.vector(2.0), axis());
    }
    for (int k = 0; k < loops; ++k) {
        const Joint joint = scene.mechanism.joints[static_cast<std::size_t>(any_of(bodies))];
        const double kind = random.number();
        if (kind < -0.4) {
            scene.mechanism.joints.push_back(joint);
        } else {
            const int i = any_of(bodies + 1);
            const int j = (i + 1 + any_of(bodies)) % (bodies + 1);
            if (kind < 0.2) {
                scene.add_joint("revolute", i, j, random.vector(2.0), common_axis);
            } else {
                add_any_joint(scene, random, i, j, random.vector(2.0), axis());
            }
        }
    }
    Mechanism mechanism = std::move(scene.mechanism);
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        const Joint& joint = mechanism.joints[j];
        if (joint.type->name != "revolute" || random.number() < 0.0) { continue; }
        const double angle = relative_angle(joint, start_state(mechanism));
        drive_angle(mechanism, static_cast<int>(j), polynomial({angle, random.number(), random.number()}));
    }
    return mechanism;
}

}  // namespace jw::test
