#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/loads.hpp"
#include "tests/support/random_dynamics.hpp"

/// Trees of joints that are all driven: where every body is follows from the drivers alone, as a product of
/// turns and shifts. Nothing of the program's equations is needed for it.
namespace jw::test {

struct DrivenTree {
    /// A joint: its child moves against its parent as the drivers say, along and about its line at the start.
    struct Limb {
        int parent = 0;
        Vec3 point;          ///< of the line at the start, global
        Vec3 axis;           ///< unit, likewise
        double sense = 1.0;  ///< -1 where the child is the joint's body i
        TimeFunction angle;  ///< [rad], zero at the start
        TimeFunction way;    ///< [m], zero at the start
        double pitch = 0.0;  ///< of a screw: way = pitch times angle [m/rad]
    };
    Mechanism mechanism;
    Loads loads;
    std::vector<Limb> limbs;  ///< of body 1 and those after it

    /// Placement of every body at time t relative to its start placement, the ground first.
    std::vector<Eigen::Isometry3d> moved(double t) const {
        std::vector<Eigen::Isometry3d> out{Eigen::Isometry3d::Identity()};
        for (const Limb& limb : limbs) {
            const double turn = limb.sense * limb.angle.at(t).f;
            const double way = limb.sense * limb.way.at(t).f + limb.pitch * turn;
            Eigen::Isometry3d own = Eigen::Isometry3d::Identity();
            own.translate(limb.point + way * limb.axis);
            own.rotate(Eigen::AngleAxisd(turn, limb.axis));
            own.translate(-limb.point);
            out.push_back(out[at(limb.parent)] * own);
        }
        return out;
    }
};

/// Random tree: up to two turns in 2 s, sometimes with a fast step; threads of either hand from 3 mm a turn.
inline DrivenTree driven_tree(Random& random, int bodies) {
    SceneBuilder scene;
    DrivenTree tree;
    const auto motion = [&](double most) {
        TimeFunction function =
            polynomial({0.0, random.number(-most, most), random.number(-0.5, 0.5) * most});
        if (random.number() > 0.6) { function.steps = {{0.0, random.number(-1.0, 1.0) * most, 0.3, 0.6}}; }
        return function;
    };
    constexpr std::array kinds{"revolute", "prismatic", "cylindrical", "screw"};
    for (int b = 1; b <= bodies; ++b) {
        const int parent = static_cast<int>(random.number(0.0, b - 1e-9));
        const int body = scene.add_body("body", random.vector(1.0));
        const std::string kind = kinds[static_cast<std::size_t>(random.number(0.0, 3.999))];
        DrivenTree::Limb limb{parent, random.vector(1.0), random.direction(), 1.0, {}, {}, 0.0};
        const bool swapped = random.number() > 0.0;
        if (swapped) { limb.sense = -1.0; }
        Joint& joint =
            scene.add_joint(kind, swapped ? body : parent, swapped ? parent : body, limb.point, limb.axis);
        const int index = static_cast<int>(scene.mechanism.joints.size()) - 1;
        if (kind == "screw") {
            limb.pitch = joint.geometry.alpha =
                (random.number() > 0.0 ? 1.0 : -1.0) * random.number(5e-4, 0.05);
        }
        if (kind != "prismatic") { drive_angle(scene.mechanism, index, limb.angle = motion(3.0)); }
        if (kind == "prismatic" || kind == "cylindrical") {
            limb.way = motion(0.3);
            const Joint& driven = scene.mechanism.joints.back();
            scene.mechanism.drivers.push_back(
                {"way of " + driven.name, index, driven.body_i, driven.body_j, displacement_of(driven),
                 limb.way});
        }
        tree.limbs.push_back(limb);
    }
    tree.mechanism = scene.mechanism;
    tree.loads.masses = random_masses(random, tree.mechanism);
    tree.loads.gravity = random.vector(9.81);
    return tree;
}

}  // namespace jw::test
