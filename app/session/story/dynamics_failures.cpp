#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/sentences.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/motion/reactions.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

/// Why a simulation ended early, in words.
namespace jw {

namespace {

/// Advice to look shortly before the end, if that is after the start: at the end itself there may be no pose.
std::string look_at(double t) {
    if (t <= 0.0) { return tr("look at that pose with 'jointwise inspect'"); }
    return tr("look at it shortly before, with 'jointwise inspect --time {0}'", number_text(0.99 * t, 3));
}

/// @param violation relative to the size of the scene
/// @param name of the joint or driver whose redundant equation is violated
std::string what_contradicts(double violation, const Mechanism& mechanism, const std::string& name) {
    const bool is_driver =
        std::ranges::find(mechanism.drivers, name, &Driver::name) != mechanism.drivers.end();
    if (is_driver && mechanism.drivers.size() > 1) {
        return tr(
            "drivers that contradict each other cannot both be followed: remove one, or make their functions "
            "agree");
    }
    constexpr double typed = 1e-3;
    if (violation > typed) {
        return mechanism.drivers.empty()
                   ? tr("the joints of a loop cannot stay closed where their axes or points do not fit")
                   : tr("the joints of a loop cannot stay closed where their axes or points do not fit, or "
                        "where drivers contradict each other");
    }
    return tr(
        "give the points and axes of a loop with all their digits, or use joints with fewer equations (a "
        "spherical and a cylindrical joint instead of two revolutes)");
}

/// Says what limits the step size, and what helps.
std::string why_so_many(const SimulationFailure& failure, const SimulationSettings& settings) {
    const MethodName& method = entry_of(settings.method);
    if (failure.bound_by_stability) {
        return tr(
            "stability, not accuracy, limits the step size: the scene is stiff (springs, dampers or light "
            "bodies with very fast transients); implicit-5 takes longer steps");
    }
    if (!method.adaptive) { return tr("use a longer step or a shorter duration"); }
    const std::string text = failure.fastest_rate > 0.0
                                 ? tr("accuracy limits the step size: body {0} turns at {1} rad/s there",
                                      in_quotes(failure.fastest), number_text(failure.fastest_rate, 3))
                                 : std::string(tr("accuracy limits the step size"));
    return tr(
        "{0}; use a shorter duration or a larger tolerance, and check that start poses do not stretch "
        "springs by mistake",
        text);
}

/// Advice to use coordinates of the bodies; empty if their equations are used already.
std::string another_way(const SimulationSettings& settings) {
    const bool of_bodies = settings.formulation == Formulation::bodies && !settings.dense;
    return of_bodies ? "" : tr("'--coordinates bodies' computes them in another way");
}

/// Two pieces of advice, of which the first may be missing.
std::string advice(const std::string& first, const std::string& second) {
    return first.empty() ? second : tr("{0}; {1}", first, second);
}

std::string contradiction_text(const SimulationFailure& failure, const Mechanism& mechanism) {
    const std::string equation = in_quotes(failure.equation_of);
    const std::string size = number_text(failure.violation, 2);
    const std::string then =
        advice(what_contradicts(failure.violation, mechanism, failure.equation_of), look_at(failure.t));
    if (failure.of_accelerations) {
        return tr(
            "equations of {0} depend linearly on those of other joints or drivers, but contradict their "
            "accelerations (relative error {1}), so the motion cannot continue; {2}",
            equation, size, then);
    }
    return tr(
        "equations of {0} depend linearly on those of other joints, but contradict them by {1} times the "
        "scene's size; {2}",
        equation, size, then);
}

std::string out_of_reach_text(const SimulationFailure& failure, const Mechanism& mechanism) {
    const std::string why = mechanism.drivers.empty()
                                ? tr("a link is at the end of its reach, or the mechanism is locked")
                                : tr("a driver leads where the mechanism cannot follow, a link is at the end "
                                     "of its reach, or the "
                                     "mechanism is locked");
    return tr(
        "equations of {0} cannot be satisfied there (violated by {1} of the scene's size): {2}",
        in_quotes(failure.equation_of), number_text(failure.violation, 2), advice(why, look_at(failure.t)));
}

std::string not_proven_text(const SimulationFailure& failure, const SimulationSettings& settings) {
    const std::string what = failure.equation_of.empty()
                                 ? "M q̈ - Q = Φqᵀλ"
                                 : tr("the acceleration equations of {0}", in_quotes(failure.equation_of));
    return tr(
        "accelerations do not satisfy {0} (relative error {1}): the pose may be singular, or the masses "
        "differ too much; {2}",
        what, number_text(failure.violation, 2), advice(another_way(settings), look_at(failure.t)));
}

std::string step_too_small_text(const SimulationFailure& failure, const SimulationSettings& settings) {
    if (entry_of(settings.method).kind == MethodKind::radau) {
        return tr(
            "no step is small enough for the tolerance; the position may be singular (a change point, a link "
            "at the end of its reach), which implicit methods pass only with loose tolerances; use a "
            "tolerance of 1e-8 or more, or explicit-8");
    }
    return tr(
        "no step is small enough for the tolerance; accelerations become unbounded there (forces too large "
        "for the masses, a singular position); {0}",
        look_at(failure.t));
}

std::string cause_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Mechanism& mechanism) {
    if (!failure.law.empty()) {
        return tr(
            "the law '{0}' has no value or no slope there, or so near that no step is short enough; expected "
            "a "
            "law that has both wherever the mechanism moves; {1}",
            failure.law, look_at(failure.t));
    }
    switch (failure.cause) {
        case SimulationFailure::Cause::contradiction: return contradiction_text(failure, mechanism);
        case SimulationFailure::Cause::out_of_reach: return out_of_reach_text(failure, mechanism);
        case SimulationFailure::Cause::not_proven: return not_proven_text(failure, settings);
        case SimulationFailure::Cause::not_finite:
            return tr(
                "the solution diverged; use a smaller step or an adaptive method (explicit-8), for stiff "
                "springs implicit-5");
        case SimulationFailure::Cause::turns_lost:
            return tr(
                "the angle of {0}, on which a load depends, changes by {1}° within one step, and turns can "
                "be "
                "counted reliably only up to 90°; use a step of {2} s or less, or an adaptive method "
                "(explicit-8)",
                in_quotes(failure.equation_of), number_text(kDegreesPerRadian * failure.turn, 3),
                number_text(0.95 * (0.5 * std::numbers::pi / failure.turn) * settings.step, 2));
        case SimulationFailure::Cause::too_many_steps:
            return tr("{0} steps were not enough; {1}", settings.most_steps, why_so_many(failure, settings));
        case SimulationFailure::Cause::step_too_small: break;
    }
    return step_too_small_text(failure, settings);
}

}  // namespace

std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Mechanism& mechanism) {
    return tr(
        "the simulation ends at t = {0} s: {1}", number_text(failure.t, 6),
        cause_text(failure, settings, mechanism));
}

std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Lesson& lesson) {
    const bool of_start = failure.cause == SimulationFailure::Cause::contradiction && failure.t == 0.0;
    if (of_start && !failure.of_accelerations) {
        const Story story(lesson, last_pose_only());
        const Step* failed = story.failure();
        // for joints that do not fit, the text below says which numbers of the lesson to check
        if (failed != nullptr && subject_of(lesson, *failed)->kind == Addition::Kind::driver) {
            return tr("{0}: {1}", what_failed(lesson, *failed), failure_text(*failed));
        }
    }
    return failure_text(failure, settings, lesson.mechanism);
}

}  // namespace jw
