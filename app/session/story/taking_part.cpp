#include "app/session/story/taking_part.hpp"

#include <algorithm>


#include "core/quantity/names.hpp"

namespace jw {

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

}  // namespace jw
