#include "app/session/story/taking_part.hpp"

#include <algorithm>
#include <numbers>

#include "core/motion/forces.hpp"
#include "core/quantity/names.hpp"

namespace jw {

namespace {

/// Angle of joint `j` with its turns; θ of a screw includes them. @param theta index of the joint's θ, or -1
double angle_with_turns(const Joint& joint, std::size_t j, int theta, const MotionFrame& frame) {
    if (theta >= 0) { return frame.state.theta[at(theta)]; }
    return relative_angle(joint, frame.state) + 2.0 * std::numbers::pi * frame.turns[j];
}

}  // namespace

Mechanism taking_part(const Lesson& lesson) {
    Mechanism mechanism = lesson.mechanism;
    const Selection added = selection_of(lesson, static_cast<int>(lesson.order.size()));
    const auto is_out = [](const std::vector<int>& all, std::size_t index) {
        return std::ranges::find(all, static_cast<int>(index)) == all.end();
    };
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        if (!is_out(added.joints, j)) { continue; }
        Joint& joint = mechanism.joints[j];
        joint.geometry.angle_dot_start.reset();
        joint.geometry.displacement_dot_start.reset();
        for (const Role role : joint.type->roles) {
            for (int k = 0; k < equations_of(joint, role); ++k) { joint.without.push_back({role, k}); }
        }
    }
    for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
        if (!is_out(added.drivers, d)) { continue; }
        const DisplacementMeasure nowhere{Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero()};
        mechanism.drivers[d] = {mechanism.drivers[d].name, -1, 0, 0, nowhere, {}};
    }
    return mechanism;
}

std::shared_ptr<const Centroidal> scene_of(const Lesson& lesson) {
    if (!lesson.dynamics) { return nullptr; }
    return std::make_shared<const Centroidal>(centroidal(taking_part(lesson), lesson.dynamics->loads));
}

std::shared_ptr<const Centroidal> scene_at(
    const std::shared_ptr<const Centroidal>& scene, const MotionFrame& begin, const MotionFrame& frame) {
    if (!scene || scene->loads.rotational_springs.empty()) { return scene; }
    auto out = std::make_shared<Centroidal>(*scene);
    const auto at_begin = kinematics_of(scene->to_centroidal(begin.state));
    begin_turns(out->loads, at_begin);
    count_turns(out->loads, at_begin);
    const std::vector<int> thetas = scene->mechanism.theta_indices();
    for (RotationalSpring& spring : out->loads.rotational_springs) {
        for (std::size_t j = 0; j < scene->mechanism.joints.size(); ++j) {
            const Joint& joint = scene->mechanism.joints[j];
            if (!acts_about(spring, joint)) { continue; }
            spring.twist_before +=
                angle_with_turns(joint, j, thetas[j], frame) - angle_with_turns(joint, j, thetas[j], begin);
            break;
        }
    }
    return out;
}

}  // namespace jw
