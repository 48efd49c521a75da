#include <algorithm>
#include <cmath>
#include <stdexcept>
#include "app/session/story/dynamics_run.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/motion/reactions.hpp"
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
        return "drivers that contradict each other cannot both be followed: remove one, or make their "
               "functions agree";
    }
    constexpr double typed = 1e-3;
    if (violation > typed) {
        return "the joints of a loop cannot stay closed where their axes or points do not fit" +
               std::string(mechanism.drivers.empty() ? "" : ", or where drivers contradict each other");
    }
    return "give the points and axes of a loop with all their digits, or use joints with fewer equations (a "
           "spherical and a cylindrical joint instead of two revolutes)";
}

/// Says what keeps the steps short and what helps.
std::string why_so_many(const SimulationFailure& failure, const SimulationSettings& settings) {
    const MethodName& method = entry_of(settings.method);
    if (failure.bound_by_stability) {
        return "stability, not accuracy, limits the step size: the scene is stiff (springs, dampers or light "
               "bodies with very fast transients); implicit-5 takes longer steps";
    }
    if (!method.adaptive) { return "use a longer step or a shorter duration"; }
    std::string text = "accuracy limits the step size";
    if (failure.fastest_rate > 0.0) {
        text += ": body " + in_quotes(failure.fastest) + " turns at " + number_text(failure.fastest_rate, 3) +
                " rad/s there";
    }
    return text +
           "; use a shorter duration or a larger tolerance, and check that start poses do not stretch "
           "springs "
           "by mistake";
}

/// Nothing to try where they come from the equations of the bodies already.
std::string another_way(const SimulationSettings& settings) {
    const bool of_bodies = settings.formulation == Formulation::bodies && !settings.dense;
    return of_bodies ? "" : "'--coordinates bodies' computes them in another way; ";
}

}  // namespace

std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Mechanism& mechanism) {
    const std::string where = "the simulation ends at t = " + number_text(failure.t, 6) + " s: ";
    switch (failure.cause) {
        case SimulationFailure::Cause::contradiction:
            if (failure.of_accelerations) {
                return where + "equations of " + in_quotes(failure.equation_of) +
                       " are redundant with those of other joints or drivers, but contradict their "
                       "accelerations "
                       "(by " +
                       number_text(failure.violation, 2) + " of their size), so the motion cannot go on; " +
                       what_contradicts(failure.violation, mechanism, failure.equation_of) + "; " +
                       look_at(failure.t);
            }
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " are redundant with those of other joints, but contradict them by " +
                   number_text(failure.violation, 2) + " of the scene's size; " +
                   what_contradicts(failure.violation, mechanism, failure.equation_of) + "; " +
                   look_at(failure.t);
        case SimulationFailure::Cause::out_of_reach:
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " cannot be satisfied there (violated by " + number_text(failure.violation, 2) +
                   " of the scene's size): " +
                   (mechanism.drivers.empty()
                        ? "a link is at the end of its reach, or the mechanism is locked; "
                        : "a driver leads where the mechanism cannot follow, a link is at the end of its "
                          "reach, or the mechanism is locked; ") +
                   look_at(failure.t);
        case SimulationFailure::Cause::not_proven:
            return where + "accelerations do not satisfy " +
                   (failure.equation_of.empty()
                        ? std::string("M q̈ - Q = Φqᵀλ")
                        : "the acceleration equations of " + in_quotes(failure.equation_of)) +
                   " (off by " + number_text(failure.violation, 2) +
                   " of their size): the pose may be singular, or the masses differ too much; " +
                   another_way(settings) + look_at(failure.t);
        case SimulationFailure::Cause::not_finite:
            return where +
                   "the solution diverged; use a smaller step or an adaptive method (explicit-8), for stiff "
                   "springs "
                   "implicit-5";
        case SimulationFailure::Cause::too_many_steps:
            return where + std::to_string(settings.most_steps) + " steps were not enough; " +
                   why_so_many(failure, settings);
        case SimulationFailure::Cause::step_too_small: break;
    }
    if (entry_of(settings.method).kind == MethodKind::radau) {
        return where +
               "no step is small enough for the tolerance; the position may be singular (a change point, a "
               "link "
               "at the end of its reach), which implicit methods pass only with loose tolerances; use a "
               "tolerance of 1e-8 or more, or explicit-8";
    }
    return where +
           "no step is small enough for the tolerance; accelerations become unbounded there (forces too "
           "large "
           "for the masses, a singular position); " +
           look_at(failure.t);
}

}  // namespace jw
