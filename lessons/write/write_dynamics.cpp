#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "core/model/placement.hpp"
#include "core/quantity/names.hpp"
#include "lessons/fields/member_keys.hpp"
#include "lessons/format/motion_keys.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

void write_plan(const Written& written, const DynamicsPlan& plan, Lines& lines) {
    const SimulationSettings& settings = plan.settings;
    const SimulationSettings usual;
    lines.table("[dynamics]");
    write_members(format::kGravity, plan.loads, lines);
    write_members(format::kDuration, plan, lines);
    if (plan.method_given || settings.method != usual.method) {
        lines.key("method", string_text(std::string(entry_of(settings.method).name)));
    }
    if (settings.treatment != usual.treatment) {
        lines.key("treatment", string_text(std::string(entry_of(settings.treatment).name)));
    }
    write_members(format::kAccuracy, settings, lines);
    if (!plan.point) { return; }
    lines.key(
        "point", "{ body = " + string_text(written.body(plan.point->body)) +
                     ", point = " + vector_text(plan.point->point_local) + " }");
    if (plan.point_at_end) { lines.key("point_at_end", *plan.point_at_end, "m"); }
}

/// True if the law of a load reads a quantity of a joint or driver that is left out: then so is the load.
bool reads_left_out(const Written& written, const std::optional<LoadLaw>& law) {
    if (!law) { return false; }
    const auto is_left_out = [&](const auto& things, Addition::Kind kind, std::string_view name) {
        const auto found =
            std::ranges::find_if(things, [&](const auto& thing) { return thing.name == name; });
        return found != things.end() && !written.has({kind, static_cast<int>(found - things.begin())});
    };
    const Mechanism& mechanism = written.lesson->mechanism;
    return std::ranges::any_of(law->quantities, [&](const LoadLaw::Quantity& quantity) {
        const std::string_view owner = owner_in(quantity.name);
        return is_left_out(mechanism.joints, Addition::Kind::joint, owner) ||
               is_left_out(mechanism.drivers, Addition::Kind::driver, owner);
    });
}

/// Keys of a direction times a magnitude, `what` being "force" or "torque".
void write_vector(const std::string& what, const std::string& unit, const auto& load, Lines& lines) {
    if (load.frame != Frame::global) { lines.key("frame", string_text(word_of(kFrames, load.frame))); }
    const Vec3& direction = load.direction;
    const TimeFunction& magnitude = load.magnitude;
    const bool constant = !load.law && magnitude == TimeFunction{.polynomial = {1.0}};
    const bool unit_length = std::abs(direction.squaredNorm() - 1.0) <= kUnitUpToRounding;
    if (!constant && unit_length) {
        lines.key("direction", typed_direction(direction));
    } else {
        lines.key(what, direction, constant ? unit : unit + ", times the function of time");
    }
    const bool is_law_alone = load.law && magnitude == TimeFunction{};
    if (!constant && !is_law_alone) { write_time_function(magnitude, false, lines); }
    if (load.law) { lines.key("law", string_text(load.law->formula.source)); }
}

/// Keys of a spring, or of a rotational spring, that do not say where it is.
template <class S>
void write_constants(const S& spring, Lines& lines) {
    constexpr bool kAngle = std::is_same_v<S, RotationalSpring>;
    const bool has_friction = spring.friction != DryFriction{};
    if (spring.stiffness != 0.0 || (spring.damping == 0.0 && !has_friction && !spring.law)) {
        lines.key("stiffness", spring.stiffness, kAngle ? "N m/rad" : "N/m");
    }
    if (spring.damping != 0.0) { lines.key("damping", spring.damping); }
    if (has_friction) {
        lines.key("friction", spring.friction.size);
        if (kAngle) { lines.angle("friction_speed", spring.friction.speed, "_per_s"); }
        if (!kAngle) { lines.key("friction_speed", spring.friction.speed, "m/s"); }
    }
    if (spring.law) { lines.key("law", string_text(spring.law->source)); }
}

/// The first written joint that a spring acts on; nothing if all such joints are left out.
/// @throws std::invalid_argument if the lesson has none
std::optional<std::string> joint_of_spring(const Written& written, const auto& acts_on) {
    const std::vector<Joint>& joints = written.lesson->mechanism.joints;
    bool any = false;
    for (std::size_t k = 0; k < joints.size(); ++k) {
        if (!acts_on(joints[k])) { continue; }
        any = true;
        if (written.has({Addition::Kind::joint, static_cast<int>(k)})) { return joints[k].name; }
    }
    if (!any) { throw std::invalid_argument("a spring of a lesson acts on the axis of one of its joints"); }
    return std::nullopt;
}

void write_spring_of_joint(const Written& written, const Spring& spring, Lines& lines) {
    const auto joint = joint_of_spring(written, [&](const Joint& j) { return acts_along(spring, j); });
    if (!joint) { return; }
    lines.table("[[spring]]");
    lines.key("joint", string_text(*joint));
    write_constants(spring, lines);
    lines.key("free_displacement", spring.free_length, "m");
}

void write_spring(const Written& written, const Spring& spring, Lines& lines) {
    if (spring.s_i_local) {
        write_spring_of_joint(written, spring, lines);
        return;
    }
    lines.table("[[spring]]");
    lines.key("bodies", written.pair(spring.body_i, spring.body_j));
    lines.key("point_i", spring.P_i_local);
    lines.key("point_j", spring.P_j_local);
    write_constants(spring, lines);
    lines.key("free_length", spring.free_length, "m");
}

void write_rotational_spring(const Written& written, const RotationalSpring& spring, Lines& lines) {
    const auto joint = joint_of_spring(written, [&](const Joint& j) { return acts_about(spring, j); });
    if (!joint) { return; }
    lines.table("[[rotational_spring]]");
    lines.key("joint", string_text(*joint));
    write_constants(spring, lines);
    lines.angle("free_angle", spring.free_angle);
}

void write_bushing(const Written& written, const Bushing& bushing, Lines& lines) {
    lines.table("[[bushing]]");
    lines.key("bodies", written.pair(bushing.body_i, bushing.body_j));
    lines.key("point_i", bushing.P_i_local);
    lines.key("point_j", bushing.P_j_local);
    lines.key("axis_i", typed_direction(bushing.axes_i_local.col(2)));
    lines.key("axis_j", typed_direction(bushing.axes_j_local.col(2)));
    lines.key("side_i", typed_direction(bushing.axes_i_local.col(0)));
    lines.key("side_j", typed_direction(bushing.axes_j_local.col(0)));
    write_members(format::kConstantsOfBushing, bushing, lines);
}

}  // namespace

void write_mass(const MassProperties& mass, Lines& lines) {
    const Mat3& J = mass.J_local;
    lines.key("mass", mass.mass, "kg");
    if (!mass.centre_local.isZero(0.0)) { lines.key("centre", mass.centre_local, "m"); }
    std::vector<double> moments{J(0, 0), J(1, 1), J(2, 2)};
    if (J(0, 1) != 0.0 || J(0, 2) != 0.0 || J(1, 2) != 0.0) {
        moments.insert(moments.end(), {J(0, 1), J(0, 2), J(1, 2)});
    }
    lines.key("inertia", list_text(moments), "kg m²");
}

void write_dynamics(const Written& written, Lines& lines) {
    if (!written.lesson->dynamics) { return; }
    const DynamicsPlan& plan = *written.lesson->dynamics;
    lines.section("dynamics: points [m] in the frames of their bodies");
    write_plan(written, plan, lines);
    for (const AppliedForce& force : plan.loads.forces) {
        if (reads_left_out(written, force.law)) { continue; }
        lines.table("[[force]]");
        lines.key("body", string_text(written.body(force.body)));
        lines.key("point", force.point_local);
        write_vector("force", "N", force, lines);
    }
    for (const AppliedTorque& torque : plan.loads.torques) {
        if (reads_left_out(written, torque.law)) { continue; }
        lines.table("[[torque]]");
        lines.key("body", string_text(written.body(torque.body)));
        if (torque.against >= 0) { lines.key("against", string_text(written.body(torque.against))); }
        write_vector("torque", "N m", torque, lines);
    }
    for (const Spring& spring : plan.loads.springs) { write_spring(written, spring, lines); }
    for (const RotationalSpring& spring : plan.loads.rotational_springs) {
        write_rotational_spring(written, spring, lines);
    }
    for (const Bushing& bushing : plan.loads.bushings) { write_bushing(written, bushing, lines); }
}

}  // namespace jw::writing
