#include "app/session/story/taking_part.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/session/story/story.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

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

void require_formulas(const Lesson& lesson, double from, double to) {
    const auto require = [&](const TimeFunction& function, const std::string& name) {
        const auto gap = function.formula ? function.formula->gap_between(from, to) : std::nullopt;
        if (!gap) { return; }
        throw std::invalid_argument(
            tr("the formula of {0} has no value, rate or acceleration at t = {1} s; expected a time range "
               "without that moment",
               name, number_text(*gap, 6)));
    };
    for (const Driver& driver : lesson.mechanism.drivers) {
        require(driver.function, in_quotes(driver.name));
    }
    if (!lesson.dynamics) { return; }
    const Loads& loads = lesson.dynamics->loads;
    for (const AppliedForce& force : loads.forces) { require(force.magnitude, tr("a force")); }
    for (const AppliedTorque& torque : loads.torques) { require(torque.magnitude, tr("a torque")); }
}

}  // namespace jw
