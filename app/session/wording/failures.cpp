#include <algorithm>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/quantity/quantity.hpp"
#include "lessons/diagnostics.hpp"

namespace jw {

namespace {

// scaled; far above the tolerance of Newton, far below a gap that can be seen
constexpr double kHolds = 1e-6;
// axes of one body that are nearer to parallel than this were meant to be parallel [rad]
constexpr double kMeantParallel = 0.2;
// rounding of a direction typed with 17 digits [rad]
constexpr double kSameDirection = 1e-12;

const std::string& joint_name(const System& system, int joint) {
    return system.mechanism().joints[static_cast<std::size_t>(joint)].name;
}

const Driver& driver_at(const System& system, int driver) {
    return system.mechanism().drivers[static_cast<std::size_t>(driver)];
}

std::string angle_text(double radians) { return number_text(radians * kDegreesPerRadian, 3) + "°"; }

std::string moment_of(const PositionFailure& failure) { return " at t = " + number_text(failure.t) + " s"; }

/// "the axes of D stay 0.0573° apart"
std::string gap_text(const System& system, const Contradiction& c) {
    const std::string joint = joint_name(system, c.joints.back());
    const std::string metres = number_text(c.gap, 3) + " m";
    const std::string angle = angle_text(c.gap);
    switch (c.role) {
        case Role::same_point: return "the points of " + joint + " stay " + metres + " apart";
        case Role::axes_parallel: return "the axes of " + joint + " stay " + angle + " apart";
        case Role::distance_parallel: return "the points of " + joint + " stay " + metres + " off its axis";
        case Role::distance_perpendicular:
            return "the points of " + joint + " stay " + metres + " apart along its axis";
        case Role::distance_perpendicular_j:
            return "the points of " + joint + " stay " + metres + " apart along its second axis";
        case Role::axes_perpendicular:
            return "the axes of " + joint + " stay " + angle + " off a right angle";
        case Role::sides_perpendicular:
            return "the sides of " + joint + " stay " + angle + " off a right angle";
        case Role::length: return "the points of " + joint + " stay " + metres + " off their distance";
        case Role::screw_advance: return "the advance of " + joint + " stays off by " + metres;
        case Role::screw_angle: break;
    }
    return "θ of " + joint + " stays " + angle + " off the angle between its bodies";
}

/// Direction of the joint's axis in one of its bodies; nothing where it has none there.
std::optional<Vec3> axis_in(const Joint& joint, int body) {
    if (!joint.type->uses(Role::axes_parallel)) { return std::nullopt; }
    if (joint.body_i == body) { return joint.geometry.s_i_local.normalized(); }
    if (joint.body_j == body) { return joint.geometry.s_j_local.normalized(); }
    return std::nullopt;
}

/// "In body 'ground' the axes of A and D are 0.0573° apart", of all pairs that look as if they were meant to
/// be parallel and are not; empty if there are none, or so many that none is the odd one.
std::string tilted_axes_text(const System& system, const std::vector<int>& joints) {
    constexpr std::size_t most = 2;
    const Mechanism& m = system.mechanism();
    std::vector<std::string> texts;
    for (std::size_t body = 0; body < m.bodies.size(); ++body) {
        for (std::size_t a = 0; a < joints.size(); ++a) {
            const Joint& first = m.joints[static_cast<std::size_t>(joints[a])];
            const auto s = axis_in(first, static_cast<int>(body));
            for (std::size_t b = a + 1; s && b < joints.size(); ++b) {
                const Joint& second = m.joints[static_cast<std::size_t>(joints[b])];
                const auto other = axis_in(second, static_cast<int>(body));
                if (!other) { continue; }
                const double angle = std::atan2(s->cross(*other).norm(), std::abs(s->dot(*other)));
                if (angle < kSameDirection || angle > kMeantParallel) { continue; }
                texts.push_back(
                    "in body " + in_quotes(m.bodies[body].name) + " the axes of " + first.name + " and " +
                    second.name + " are " + angle_text(angle) + " apart");
            }
        }
    }
    return texts.empty() || texts.size() > most ? "" : listed(texts);
}

std::string joints_text(const System& system, const PositionFailure& failure) {
    const Contradiction& c = *failure.contradiction;
    std::vector<std::string> names;
    for (const int joint : c.joints) { names.push_back(joint_name(system, joint)); }
    std::string text;
    if (names.size() == 1) {
        text =
            "Joint " + names.front() + " cannot be closed" + moment_of(failure) + ": " + gap_text(system, c);
    } else {
        text = "Joints " + listed(names) + " cannot all be closed" + moment_of(failure) +
               ": with the others closed, " + gap_text(system, c);
    }
    text += " (shared out among all, " + row_label(system, failure.row) + " is off by " +
            small_text(failure.value) + "). ";
    const std::string tilted =
        c.role == Role::axes_parallel ? tilted_axes_text(system, c.joints) : std::string();
    if (!tilted.empty()) {
        return text + "Check the axes: " + tilted +
               ". A spherical and a cylindrical joint in place of two hinges would not ask for that.";
    }
    return text + "Check lengths, points and axes of " + (names.size() == 1 ? "it" : "these joints") + ".";
}

/// "62.25°" of what a driver prescribes, to a hundredth of the gap: the fit that found it is no better.
std::string measure_text(const Driver& driver, double value, double gap) {
    constexpr int digits = 9;  // of two that differ little
    const Unit unit = unit_of(driver.measure);
    const double factor = unit == Unit::radian ? kDegreesPerRadian : 1.0;
    const double step = 0.01 * std::pow(10.0, std::floor(std::log10(std::max(factor * gap, 1e-300))));
    const std::string number = number_text(step * std::round(factor * value / step), digits);
    return number + (unit == Unit::radian ? "°" : unit == Unit::metre ? " m" : "");
}

std::string drivers_text(const System& system, const PositionFailure& failure) {
    const Contradiction& c = *failure.contradiction;
    const Driver& last = driver_at(system, c.drivers.back());
    const std::string when = " at t = " + number_text(failure.t) + " s";
    const std::string asks = measure_text(last, c.asked, c.gap);
    const std::string finds = measure_text(last, c.found, c.gap);
    const std::string apart = measure_text(last, c.gap, c.gap);
    if (c.drivers.size() == 1) {
        return "Driver " + last.name + " leads where the mechanism cannot follow" + when + ": it asks for " +
               asks + ", and the nearest that can be reached is " + finds + ", " + apart +
               " away. Let it end within reach, or change the lengths.";
    }
    std::vector<std::string> names;
    for (const int driver : c.drivers) { names.push_back(driver_at(system, driver).name); }
    const std::string others = c.drivers.size() == 2 ? names.front() + " leads" : "the others lead";
    return "Drivers " + listed(names) + " contradict each other" + when + ": " + last.name + " asks for " +
           asks + " where " + others + " to " + finds + ", " + apart +
           " apart. Leave one of them out, or make their functions agree.";
}

std::string cannot_close_text(const System& system, const PositionFailure& failure) {
    if (failure.contradiction) {
        return failure.contradiction->drivers.empty() ? joints_text(system, failure)
                                                      : drivers_text(system, failure);
    }
    return "The equations cannot be met together" + moment_of(failure) + ": the closest fit leaves " +
           row_label(system, failure.row) + " off by " + small_text(failure.value) +
           ". Check lengths, points and axes of this joint and of those before it" +
           (system.drivers().empty() ? "" : ", and what the drivers ask for") + ".";
}

std::string singular_text(const System& system, const PositionFailure& failure) {
    std::string text = "The way" + moment_of(failure) +
                       " leads through a singular position, where equations lose their independence";
    if (failure.residual >= kHolds) {
        text += " (" + row_label(system, failure.row) + " is off by " + small_text(failure.value) + " there)";
    }
    return text + ". Start on the intended side of it" +
           (system.drivers().empty() ? "." : ", or drive another coordinate.");
}

std::string no_convergence_text(const System& system, const PositionFailure& failure) {
    std::string text = "Newton-Raphson did not converge" + moment_of(failure) + " within " +
                       count_text(failure.iterations, "iteration");
    if (failure.residual >= kHolds) {
        text += ": " + row_label(system, failure.row) + " is off by " + small_text(failure.value);
    } else {
        text += ": the pose that it found satisfies the equations, but this pose does not lead there";
    }
    return text +
           ". Whether there is a pose that meets all equations is not known; a start pose nearer to it" +
           (system.drivers().empty() ? "" : " or a slower driver") + " may help.";
}

}  // namespace

std::string failure_text(const System& system, const PositionFailure& failure) {
    switch (failure.cause) {
        case FailureCause::cannot_close: return cannot_close_text(system, failure);
        case FailureCause::wrong_branch:
            return "Only solutions on a wrong branch were found" + moment_of(failure) +
                   (failure.branch ? ": " + branch_text(system, *failure.branch) : "") +
                   ". Give a start pose nearer to the intended one.";
        case FailureCause::singular: return singular_text(system, failure);
        case FailureCause::no_convergence: break;
    }
    return no_convergence_text(system, failure);
}

}  // namespace jw
