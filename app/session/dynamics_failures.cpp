#include <algorithm>
#include <cmath>
#include <stdexcept>
#include "app/session/dynamics_run.hpp"
#include "app/session/numbers.hpp"
#include "core/dynamics/reactions.hpp"
#include "lessons/diagnostics.hpp"

/// Why a simulation ended early, in words.
namespace jw {

namespace {

/// Shortly before, as long as that is after the start: at the end itself there may be no pose.
std::string look_at(double t) {
    if (t <= 0.0) { return "look at that pose with 'jointwise inspect'"; }
    return "look at it shortly before, with 'jointwise inspect --time " + number_text(0.99 * t, 3) + "'";
}

/// @param violation by the size of the scene
/// @param name of the joint or driver that misses what it repeats
std::string what_contradicts(double violation, const Mechanism& mechanism, const std::string& name) {
    const bool is_driver =
        std::ranges::find(mechanism.drivers, name, &Driver::name) != mechanism.drivers.end();
    if (is_driver && mechanism.drivers.size() > 1) {
        return "drivers that ask for different things cannot be followed together: leave one out, or make "
               "their "
               "functions agree";
    }
    constexpr double typed = 1e-3;
    if (violation > typed) {
        return "joints of a loop whose axes or points do not fit" +
               std::string(mechanism.drivers.empty() ? "" : ", or drivers that lead apart,") +
               " cannot be kept together";
    }
    return "points and axes of a loop want all their digits, or joints that ask for less (a spherical and a "
           "cylindrical one in the place of two revolutes)";
}

/// What keeps the steps short, and what helps.
std::string why_so_many(const SimulationFailure& failure, const SimulationSettings& settings) {
    const MethodName& method = entry_of(settings.method);
    if (failure.bound_by_stability) {
        return "stability kept them short, not accuracy: the scene is stiff (springs, dampers or light "
               "bodies "
               "that settle in no time); implicit-5 takes longer ones";
    }
    if (!method.adaptive) { return "a longer step or a shorter duration takes fewer"; }
    std::string text = "accuracy kept them short";
    if (failure.fastest_rate > 0.0) {
        text += ": body " + in_quotes(failure.fastest) + " turns at " + number_text(failure.fastest_rate, 3) +
                " rad/s there";
    }
    return text +
           "; a shorter duration or a larger tolerance takes fewer, and start poses that do not fit "
           "stretch springs to forces that nobody meant";
}

/// Nothing to try where they come from the equations of the bodies already.
std::string another_way(const SimulationSettings& settings) {
    const bool of_bodies = settings.formulation == Formulation::bodies && !settings.dense;
    return of_bodies ? "" : "with '--coordinates bodies' they are worked out in another way; ";
}

}  // namespace

std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Mechanism& mechanism) {
    const std::string where = "the simulation ends at t = " + number_text(failure.t, 6) + " s: ";
    switch (failure.cause) {
        case SimulationFailure::Cause::contradiction:
            if (failure.of_accelerations) {
                return where + "equations of " + in_quotes(failure.equation_of) +
                       " repeat those of other joints or drivers, but ask for other accelerations (by " +
                       number_text(failure.violation, 2) + " of their size): they part from there on; " +
                       what_contradicts(failure.violation, mechanism, failure.equation_of) + "; " +
                       look_at(failure.t);
            }
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " repeat those of other joints, but miss them by " + number_text(failure.violation, 2) +
                   " of the scene's size; " +
                   what_contradicts(failure.violation, mechanism, failure.equation_of) + "; " +
                   look_at(failure.t);
        case SimulationFailure::Cause::out_of_reach:
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " cannot be met there (off by " + number_text(failure.violation, 2) +
                   " of the scene's size): " +
                   (mechanism.drivers.empty()
                        ? "a reach ends there, or the mechanism is locked; "
                        : "a driver leads where the mechanism cannot follow, a reach ends, or it is "
                          "locked; ") +
                   look_at(failure.t);
        case SimulationFailure::Cause::not_proven:
            return where + "accelerations do not satisfy " +
                   (failure.equation_of.empty()
                        ? std::string("M q̈ - Q = Φqᵀλ")
                        : "the acceleration equations of " + in_quotes(failure.equation_of)) +
                   " (off by " + number_text(failure.violation, 2) +
                   " of their size): the pose may be singular, or masses too far apart; " +
                   another_way(settings) + look_at(failure.t);
        case SimulationFailure::Cause::not_finite:
            return where +
                   "the numbers grew beyond all bounds; a smaller step or an adaptive method (explicit-8) "
                   "helps, for stiff springs implicit-5";
        case SimulationFailure::Cause::too_many_steps:
            return where + std::to_string(settings.most_steps) + " steps were not enough; " +
                   why_so_many(failure, settings);
        case SimulationFailure::Cause::step_too_small: break;
    }
    if (entry_of(settings.method).kind == MethodKind::radau) {
        return where +
               "no step is small enough for the tolerance; the position may be singular (a change point, a "
               "reach at its end), which implicit methods pass with loose tolerances only; a tolerance from "
               "1e-8 on, or explicit-8, helps";
    }
    return where +
           "no step is small enough for the tolerance; accelerations grow beyond all bounds there (forces "
           "that are very large beside masses, a singular position); " +
           look_at(failure.t);
}

}  // namespace jw
