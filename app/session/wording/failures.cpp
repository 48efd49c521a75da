#include <algorithm>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "core/kinematics/turning_point.hpp"
#include "core/quantity/quantity.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

// scaled; far above the tolerance of Newton, far below a gap that can be seen
constexpr double kHolds = 1e-6;
// axes of one body that are nearer to parallel than this were meant to be parallel [rad]
constexpr double kMeantParallel = 0.2;
// rounding of a direction typed with 17 digits [rad]
constexpr double kSameDirection = 1e-12;

const std::string& joint_name(const System& system, int joint) {
    return system.mechanism().joints[at(joint)].name;
}

const Driver& driver_at(const System& system, int driver) { return system.mechanism().drivers[at(driver)]; }

std::string angle_text(double radians) { return number_text(radians * kDegreesPerRadian, 3) + "°"; }

std::string moment_of(const PositionFailure& failure) { return number_text(failure.t); }

/// "the axes of D stay 0.0573° apart"
std::string gap_text(const System& system, const Contradiction& c) {
    const std::string joint = joint_name(system, c.joints.back());
    const std::string metres = number_text(c.gap, 3) + " m";
    const std::string angle = angle_text(c.gap);
    switch (c.role) {
        case Role::same_point: return tr("the points of {0} stay {1} apart", joint, metres);
        case Role::axes_parallel: return tr("the axes of {0} stay {1} apart", joint, angle);
        case Role::distance_parallel: return tr("the points of {0} stay {1} off its axis", joint, metres);
        case Role::distance_perpendicular:
            return tr("the points of {0} stay {1} apart along its axis", joint, metres);
        case Role::distance_perpendicular_j:
            return tr("the points of {0} stay {1} apart along its second axis", joint, metres);
        case Role::axes_perpendicular: return tr("the axes of {0} stay {1} off a right angle", joint, angle);
        case Role::sides_perpendicular:
            return tr("the sides of {0} stay {1} off a right angle", joint, angle);
        case Role::length: return tr("the points of {0} stay {1} off their distance", joint, metres);
        case Role::formula: return tr("the formula of {0} stays off by {1}", joint, number_text(c.gap, 3));
        case Role::screw_advance:
        case Role::rack_advance: return tr("the advance of {0} stays off by {1}", joint, metres);
        case Role::curve_x:
        case Role::curve_y:
        case Role::curve_z: return tr("the point of {0} stays {1} off its curve", joint, metres);
        case Role::wheel_j:
        case Role::bevel_j: return tr("the second wheel of {0} stays {1} off its angle", joint, angle);
        case Role::wheel_i:
        case Role::bevel_i:
        case Role::rack_angle:
        case Role::screw_angle: break;
    }
    return tr("θ of {0} stays {1} off the angle between its bodies", joint, angle);
}

/// Direction of the joint's axis in one of its bodies; nothing where it has none there.
std::optional<Vec3> axis_in(const Joint& joint, int body) {
    if (!joint.type->uses(Role::axes_parallel)) { return std::nullopt; }
    if (joint.body_i == body) { return joint.geometry.s_i_local.normalized(); }
    if (joint.body_j == body) { return joint.geometry.s_j_local.normalized(); }
    return std::nullopt;
}

/// "In body 'ground' the axes of A and D are 0.0573° apart", for all pairs that seem to be meant parallel and
/// are not; empty if there are none, or too many to single out one.
std::string tilted_axes_text(const System& system, const std::vector<int>& joints) {
    constexpr std::size_t most = 2;
    const Mechanism& m = system.mechanism();
    std::vector<std::string> texts;
    for (std::size_t body = 0; body < m.bodies.size(); ++body) {
        for (std::size_t a = 0; a < joints.size(); ++a) {
            const Joint& first = m.joints[at(joints[a])];
            const auto s = axis_in(first, static_cast<int>(body));
            for (std::size_t b = a + 1; s && b < joints.size(); ++b) {
                const Joint& second = m.joints[at(joints[b])];
                const auto other = axis_in(second, static_cast<int>(body));
                if (!other) { continue; }
                const double angle = elementary::atan2(s->cross(*other).norm(), std::abs(s->dot(*other)));
                if (angle < kSameDirection || angle > kMeantParallel) { continue; }
                texts.push_back(
                    tr("in body {0} the axes of {1} and {2} are {3} apart", in_quotes(m.bodies[body].name),
                       first.name, second.name, angle_text(angle)));
            }
        }
    }
    return texts.empty() || texts.size() > most ? "" : listed(texts);
}

std::string joints_text(const System& system, const PositionFailure& failure) {
    const Contradiction& c = *failure.contradiction;
    std::vector<std::string> names;
    for (const int joint : c.joints) { names.push_back(joint_name(system, joint)); }
    const bool one = names.size() == 1;
    const std::string gap =
        tr("{0} (if the error is shared by all, {1} is off by {2})", gap_text(system, c),
           row_label(system, failure.row), small_text(failure.value));
    const std::string text =
        one ? tr("Joint {0} cannot be closed at t = {1} s: {2}.", names.front(), moment_of(failure), gap)
            : tr("Joints {0} cannot all be closed at t = {1} s: with the others closed, {2}.", listed(names),
                 moment_of(failure), gap);
    const std::string tilted =
        c.role == Role::axes_parallel ? tilted_axes_text(system, c.joints) : std::string();
    if (!tilted.empty()) {
        return followed(
            text, tr("Check the axes: {0}. A spherical and a cylindrical joint in place of two hinges would "
                     "allow this angle.",
                     tilted));
    }
    return followed(
        text, one ? tr("Check its lengths, points and axes.")
                  : tr("Check lengths, points and axes of these joints."));
}

/// The value of a driver's measure, "62.25°", to a hundredth of the gap: the fit that found it is not more
/// accurate.
std::string measure_text(const Driver& driver, double value, double gap) {
    constexpr int digits = 9;  // enough for two values that differ little
    const Unit unit = unit_of(driver.measure);
    const double factor = unit == Unit::radian ? kDegreesPerRadian : 1.0;
    const double step =
        0.01 * elementary::pow(10.0, std::floor(elementary::log10(std::max(factor * gap, 1e-300))));
    const std::string number = number_text(step * std::round(factor * value / step), digits);
    return number + (unit == Unit::radian ? "°" : unit == Unit::metre ? " m" : "");
}

std::string drivers_text(const System& system, const PositionFailure& failure) {
    const Contradiction& c = *failure.contradiction;
    const Driver& last = driver_at(system, c.drivers.back());
    const std::string when = moment_of(failure);
    const std::string asks = measure_text(last, c.asked, c.gap);
    const std::string finds = measure_text(last, c.found, c.gap);
    const std::string apart = measure_text(last, c.gap, c.gap);
    if (c.drivers.size() == 1) {
        return tr(
            "Driver {0} leads where the mechanism cannot follow at t = {1} s: it asks for {2}, and the "
            "nearest that can be reached is {3}, {4} away. Let the driver end within reach, or change the "
            "lengths.",
            last.name, when, asks, finds, apart);
    }
    std::vector<std::string> names;
    for (const int driver : c.drivers) { names.push_back(driver_at(system, driver).name); }
    const std::string others = c.drivers.size() == 2
                                   ? tr("{0} asks for {1}, but {2} leads to {3}, a difference of {4}",
                                        last.name, asks, names.front(), finds, apart)
                                   : tr("{0} asks for {1}, but the others lead to {2}, a difference of {3}",
                                        last.name, asks, finds, apart);
    return tr(
        "Drivers {0} contradict each other at t = {1} s: {2}. Take one of them out, or make their functions "
        "agree.",
        listed(names), when, others);
}

std::string cannot_close_text(const System& system, const PositionFailure& failure) {
    if (failure.contradiction) {
        return failure.contradiction->drivers.empty() ? joints_text(system, failure)
                                                      : drivers_text(system, failure);
    }
    const std::string text =
        tr("The equations cannot all be satisfied at t = {0} s: the closest fit leaves {1} off by {2}.",
           moment_of(failure), row_label(system, failure.row), small_text(failure.value));
    return followed(
        text, system.drivers().empty()
                  ? tr("Check lengths, points and axes of this joint and of those before it.")
                  : tr("Check lengths, points and axes of this joint and of those before it, and what the "
                       "drivers ask for."));
}

std::string singular_text(const System& system, const PositionFailure& failure) {
    const std::string text =
        failure.residual >= kHolds
            ? tr("At t = {0} s the motion reaches a singular position, where equations become dependent ({1} "
                 "is off by {2} there).",
                 moment_of(failure), row_label(system, failure.row), small_text(failure.value))
            : tr("At t = {0} s the motion reaches a singular position, where equations become dependent.",
                 moment_of(failure));
    return followed(
        text, system.drivers().empty()
                  ? tr("Start on the intended side of it.")
                  : tr("Start on the intended side of it, or drive another coordinate."));
}

std::string turning_point_text(const System& system, const PositionFailure& failure) {
    constexpr double digits_of = 1e-3;  // rad or m: four decimals of a degree
    // a turning point is proved if one driver moves alone; where it ends, another may begin to move
    const DriverConstraint* moving = only_moving_driver(system, failure.t);
    const Driver& driver = driver_at(system, (moving != nullptr ? *moving : system.drivers().front()).driver);
    return followed(
        tr("The motion turns back at t = {0} s: on the branch of the start pose, driver {1} cannot go beyond "
           "{2}.",
           moment_of(failure), driver.name, measure_text(driver, driver.function.at(failure.t).f, digits_of)),
        tr("Let the driver end within reach, or change the lengths."));
}

std::string likely_turning_point_text(const PositionFailure& failure) {
    return followed(
        tr("It seems that the motion turns back at t = {0} s, and that no pose on the branch of the start "
           "pose lies beyond; this is not proved.",
           moment_of(failure)),
        tr("Let the drivers end there, or change the lengths."));
}

std::string undecided_text(const PositionFailure& failure) {
    return followed(
        tr("At t = {0} s branches of the motion come so near to each other that rounding hides on which one "
           "it continues.",
           moment_of(failure)),
        tr("Make the lengths differ by more, or use another driver."));
}

std::string no_value_text(const System& system, const PositionFailure& failure) {
    return followed(
        tr("{0} has no value, or no derivative, at the start pose at t = {1} s: its formula divides by 0 "
           "there, or leaves the range of a function.",
           row_label(system, failure.row), moment_of(failure)),
        tr("Start at a pose where the formula has both."));
}

std::string no_convergence_text(const System& system, const PositionFailure& failure) {
    if (failure.iterations == 0) {
        return followed(
            tr("The motion cannot be followed beyond t = {0} s: too many steps would be needed, or even the "
               "smallest one could not be proved.",
               moment_of(failure)),
            tr("A body may turn very fast here, or an equation may change without limit or have no "
               "derivative: see the velocities and the row of the Jacobian just before."));
    }
    const std::string within = tr_count(failure.iterations, "{0} iteration", "{0} iterations");
    const std::string text =
        failure.residual >= kHolds
            ? tr("Newton-Raphson did not converge at t = {0} s within {1}: {2} is off by {3}.",
                 moment_of(failure), within, row_label(system, failure.row), small_text(failure.value))
            : tr("Newton-Raphson did not converge at t = {0} s within {1}: it found a pose that satisfies "
                 "the equations but cannot be reached from the present one.",
                 moment_of(failure), within);
    return followed(
        text, system.drivers().empty() ? tr("It is not known whether a pose satisfies all equations; a start "
                                            "pose nearer to one may help.")
                                       : tr("It is not known whether a pose satisfies all equations; a start "
                                            "pose nearer to one, or a slower driver, may help."));
}

std::string wrong_branch_text(const System& system, const PositionFailure& failure) {
    const std::string text =
        failure.branch ? tr("Only solutions on a wrong branch were found at t = {0} s: {1}.",
                            moment_of(failure), branch_text(system, *failure.branch))
                       : tr("Only solutions on a wrong branch were found at t = {0} s.", moment_of(failure));
    return followed(text, tr("Give a start pose nearer to the intended one."));
}

}  // namespace

std::string failure_text(const System& system, const PositionFailure& failure) {
    switch (failure.cause) {
        case FailureCause::cannot_close: return cannot_close_text(system, failure);
        case FailureCause::wrong_branch: return wrong_branch_text(system, failure);
        case FailureCause::singular: return singular_text(system, failure);
        case FailureCause::turning_point: return turning_point_text(system, failure);
        case FailureCause::likely_turning_point: return likely_turning_point_text(failure);
        case FailureCause::no_value: return no_value_text(system, failure);
        case FailureCause::undecided: return undecided_text(failure);
        case FailureCause::no_convergence: break;
    }
    return no_convergence_text(system, failure);
}

}  // namespace jw
