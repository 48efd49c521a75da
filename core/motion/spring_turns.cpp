#include "core/motion/spring_turns.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "core/motion/forces.hpp"

namespace jw {

bool depends_on_turns(const Loads& loads) {
    bool any = false;
    for_each_angle(loads, [&](const RotationalSpring& spring) { any = any || spring.depends_on_angle(); });
    return any;
}

SpringTurns::SpringTurns(
    std::shared_ptr<const Centroidal> scene, const State& begin, const std::vector<int>& turns)
    : scene_(std::move(scene)) {
    if (!scene_ || !depends_on_turns(scene_->loads)) { return; }
    auto twisted = std::make_shared<Centroidal>(*scene_);
    // angles do not depend on where the frames of the bodies lie
    const auto bodies = kinematics_of(begin);
    begin_turns(twisted->loads, bodies);
    count_turns(twisted->loads, bodies);
    scene_ = twisted;
    const std::vector<Joint>& joints = scene_->mechanism.joints;
    const std::vector<int> thetas = scene_->mechanism.theta_indices();
    for_each_angle(scene_->loads, [&](const RotationalSpring& spring) {
        const auto joint =
            std::ranges::find_if(joints, [&](const Joint& j) { return acts_about(spring, j); });
        Turning turning{static_cast<std::size_t>(joint - joints.begin())};
        if (joint != joints.end()) {
            turning.theta = thetas[turning.joint];
            turning.begin = angle_of(turning, begin, turns);
        }
        turning_.push_back(turning);
    });
}

double SpringTurns::angle_of(
    const Turning& turning, const State& state, const std::vector<int>& turns) const {
    if (turning.theta >= 0) { return state.theta[jw::at(turning.theta)]; }
    return relative_angle(scene_->mechanism.joints[turning.joint], state) +
           2.0 * std::numbers::pi * turns[turning.joint];
}

std::shared_ptr<const Centroidal> SpringTurns::at(const State& state, const std::vector<int>& turns) const {
    if (turning_.empty()) { return scene_; }
    auto out = std::make_shared<Centroidal>(*scene_);
    auto turning = turning_.begin();
    for_each_angle(out->loads, [&](RotationalSpring& spring) {
        if (turning->joint < scene_->mechanism.joints.size()) {
            spring.twist_before += angle_of(*turning, state, turns) - turning->begin;
        }
        ++turning;
    });
    return out;
}

}  // namespace jw
