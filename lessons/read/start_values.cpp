#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/jets/coordinates.hpp"
#include "core/kinematics/paths/start_values.hpp"
#include "core/poses/position.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

// of start values and of functions that begin with them [rad or m]
constexpr double kStartRounding = 1e-9;

std::string text_of_value(const StartValue& given, double value) {
    if (std::abs(value) < kStartRounding) { value = 0.0; }
    return given.is_angle ? short_number(value * 180.0 / std::numbers::pi) + " deg"
                          : short_number(value) + " m";
}

Measure measure_of(const StartValue& given, const Joint& joint) {
    if (!given.is_angle) { return displacement_of(joint); }
    return joint.type->artificial > 0 ? Measure(ThetaMeasure{}) : Measure(angle_of(joint));
}

/// A driver whose function begins with the value of its quantity at the start, whatever that is: it does not
/// constrain the start.
bool begins_with_start(const Reading& reading, const FromStart& from, double t) {
    const double f = reading.lesson.mechanism.drivers[at(from.driver)].function.at(t).f;
    return std::abs(f - from.value) <= kStartRounding;
}

/// Assembles joints and drivers in the order of the lesson, as its steps do. @return false if that fails
bool assemble_in_order(
    const Reading& reading, const std::vector<int>& idle, double t, Selection& present, State& state) {
    const Lesson& lesson = reading.lesson;
    for (const Addition& added : lesson.order) {
        const bool is_joint = added.kind == Addition::Kind::joint;
        if (!is_joint && std::ranges::find(idle, added.index) != idle.end()) { continue; }
        (is_joint ? present.joints : present.drivers).push_back(added.index);
        System system(lesson.mechanism, present);
        system.choose_rows(state);
        const bool closed = with_choice(lesson.coordinates, [&](auto choice) {
            return solve_position<decltype(choice)>(system, state, t).ok();
        });
        if (!closed) { return false; }
    }
    return true;
}

/// What ends the motion to a start value, after "the motion from the pose in the file".
std::string end_text(FailureCause cause, const std::string& where) {
    switch (cause) {
        case FailureCause::turning_point: return "turns back at " + where;
        case FailureCause::likely_turning_point: return "probably turns back at " + where;
        case FailureCause::singular: return "comes to a singular position at " + where;
        case FailureCause::undecided:
            return "comes to " + where + ", where branches are too near to each other";
        case FailureCause::cannot_close:
        case FailureCause::wrong_branch:
        case FailureCause::no_value:
        case FailureCause::no_convergence: break;
    }
    return "cannot be followed beyond " + where;
}

void report_missed(const Reading& reading, const Selection& present, const MissedValue& missed) {
    const StartValue& given = reading.start_values[missed.given];
    const std::string found = text_of_value(given, missed.found);
    const std::string head = "joint " + in_quotes(reading.joint_at(given.joint).name) + " cannot start at " +
                             text_of_value(given, given.value) + ": ";
    const auto tell = [&](const std::string& why, const std::string& hint) {
        reading.report(Code::start_value, given.span, head + why, hint);
    };
    if (missed.failure) {
        return tell(
            "the motion from the pose in the file " + end_text(missed.failure->cause, found),
            "give a value before that, or poses of the bodies on the branch that reaches it");
    }
    const auto& drivers = reading.lesson.mechanism.drivers;
    const auto own = std::ranges::find_if(present.drivers, [&](int d) {
        const Measure& measure = drivers[at(d)].measure;
        return drivers[at(d)].joint == given.joint &&
               measure.index() == measure_of(given, reading.joint_at(given.joint)).index();
    });
    if (own != present.drivers.end()) {
        return tell(
            "driver " + in_quotes(drivers[at(*own)].name) + " starts it at " + found,
            "remove this value, or let the driver begin with it, as with from_start = true");
    }
    if (missed.is_determined) {
        return tell(
            "joints, drivers and other start values place it at " + found,
            "remove this value, or give " + found);
    }
    tell(
        "no motion of the pose in the file changes it from " + found + " to first order",
        "give poses of the bodies away from this position");
}

/// Lets the lesson start in the poses of a state. Velocities that were given in the global frame stay there.
void start_from(Reading& reading, const State& state, const std::vector<FromStart>& begin_with_start) {
    Mechanism& mechanism = reading.lesson.mechanism;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        Body& body = mechanism.bodies[b];
        if (body.fixed) { continue; }
        const Vec3 omega_global = rotation_of(body) * body.omega_local;
        // a lesson has no minus zero
        body.r = state.r[b] + Vec3::Zero();
        body.p = state.p[b] + Vec4::Zero();
        const bool is_global =
            std::ranges::find(reading.omegas_global, static_cast<int>(b)) != reading.omegas_global.end();
        if (is_global) { body.omega_local = rotation_of(body).transpose() * omega_global; }
    }
    // a pose does not tell how often a screw or wheels have turned
    const std::vector<int> thetas = mechanism.theta_indices();
    for (std::size_t j = 0; j < thetas.size(); ++j) {
        if (thetas[j] >= 0) { mechanism.joints[j].geometry.theta_start = state.theta[at(thetas[j])] + 0.0; }
    }
    for (const FromStart& from : begin_with_start) {
        Driver& driver = mechanism.drivers[at(from.driver)];
        driver.function.polynomial[0] += start_value(reading, driver) - from.value;
    }
}

}  // namespace

void read_start_values(Fields& fields, const Joint& joint, int index, Reading& reading) {
    if (joint.type->has_angle()) {
        const auto angle = fields.angle("angle");
        // turns are counted from the start, except those of a coordinate of the joint
        if (angle && joint.type->artificial == 0 && std::abs(angle->value) > std::numbers::pi) {
            fields.report(
                Code::out_of_range, angle->span,
                "the joint starts at " + short_number(angle->value * 180.0 / std::numbers::pi) +
                    " deg; expected an angle from -180 to 180 deg, since turns are counted from the start");
        } else if (angle) {
            reading.start_values.push_back({index, true, angle->value, angle->span});
        }
    }
    if (!joint.type->has_displacement()) { return; }
    if (const auto way = fields.number("displacement")) {
        reading.start_values.push_back({index, false, way->value, way->span});
    }
}

void take_start_values(Reading& reading) {
    if (reading.start_values.empty()) { return; }
    const Lesson& lesson = reading.lesson;
    const double t = lesson.motion ? lesson.motion->from : 0.0;
    std::vector<FromStart> begin_with_start;
    std::vector<int> idle;
    for (const FromStart& from : reading.from_start) {
        if (!begins_with_start(reading, from, t)) { continue; }
        begin_with_start.push_back(from);
        idle.push_back(from.driver);
    }
    Selection present;
    State state = start_state(lesson.mechanism);
    // a lesson that cannot be assembled says so in its steps
    if (!assemble_in_order(reading, idle, t, present, state)) { return; }
    std::vector<GivenValue> values;
    for (const StartValue& given : reading.start_values) {
        values.push_back({given.joint, measure_of(given, reading.joint_at(given.joint)), given.value});
    }
    for (const int d : idle) {
        const Driver& driver = lesson.mechanism.drivers[at(d)];
        if (driver.joint >= 0) { values.push_back({driver.joint, driver.measure, std::nullopt}); }
    }
    if (const auto missed = move_to_values(lesson.mechanism, present, values, t, state)) {
        report_missed(reading, present, *missed);
    } else {
        start_from(reading, state, begin_with_start);
    }
}

}  // namespace jw::reading
