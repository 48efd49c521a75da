#include "app/session/view/inspection.hpp"

#include <algorithm>

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/sentences.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/svd.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

namespace {

MatrixX dense(const SparseRows& rows) {
    MatrixX matrix(static_cast<Eigen::Index>(rows.rows.size()), rows.columns);
    rows.write(matrix);
    return matrix;
}

/// Computes the numbers from system, state, velocity and t.
void evaluate(Inspection& inspection, Spectrum spectrum) {
    with_choice(inspection.choice, [&](auto c) {
        Assembler<decltype(c)> assembler(*inspection.system);
        assembler.assemble_phi_and_jacobian(inspection.state, inspection.t);
        assembler.assemble_nu(inspection.t);
        assembler.assemble_gamma(inspection.state, inspection.velocity, inspection.t);
        inspection.phi = assembler.phi();
        inspection.jacobian = assembler.sparse_jacobian();
        inspection.nu = assembler.nu();
        inspection.gamma = assembler.gamma();
    });
    const System& system = *inspection.system;
    inspection.residuals = residuals_of(
        system, inspection.state, inspection.velocity, zero_motion(system.mechanism()), inspection.t);
    inspection.rank = rank_of(system, inspection.state, inspection.t, spectrum == Spectrum::always);
    if (!inspection.rank.has_spectrum) { return; }
    const Svd svd = svd_of(dense(inspection.jacobian));
    inspection.singular_values = svd.sigma;
    inspection.singular_value_error = svd.error;
    inspection.sound = svd.sound;
}

/// True if `t` is before or after the motion by more than its length: there the lesson promises nothing, and
/// a pose that cannot be found says nothing about the mechanism.
bool is_far_outside(const Lesson& lesson, double t) {
    if (!lesson.motion) { return false; }
    const auto& [from, to, duration, steps] = *lesson.motion;
    const double length = to - from;
    return t < from - length || t > to + length;
}

PoseNotReached far_outside(const Lesson& lesson, double t, double reached) {
    return PoseNotReached(
        lesson.file_name + ": " +
        tr("t = {0} s lies far outside the lesson's motion, which goes from {1} s to {2} s. The motion can "
           "be followed as far as {3} s.",
           number_text(t, 4), number_text(lesson.motion->from, 4), number_text(lesson.motion->to, 4),
           number_text(reached, 4)));
}

}  // namespace

PoseNotReached not_reached(const Lesson& lesson, const System& system, const PositionFailure& failure) {
    return PoseNotReached(lesson.file_name + ": " + failure_text(system, failure));
}

PoseNotReached not_reached(const Lesson& lesson, const Step& failed) {
    return PoseNotReached(
        lesson.file_name + ": " + what_failed(lesson, failed) + ": " + failure_text(failed));
}

bool is_shown_dense(const Inspection& inspection) {
    return inspection.system->columns(3) <= kMostColumnsWithSpectrum;
}

FreedomJudgements judgements_of(const Inspection& inspection) {
    if (!inspection.rank.assembled) { return {}; }
    return judgements_on(*inspection.system, inspection.state, inspection.t, inspection.rank.free_motions);
}

Inspection inspect_step(const Story& story, int index, CoordinateChoice choice, Spectrum spectrum) {
    const Step& step = story.steps().at(at(index));
    Inspection inspection;
    inspection.moment = tr("step {0}", index);
    inspection.step = index;
    inspection.choice = choice;
    inspection.system = step.system;
    inspection.state = step.state;
    inspection.velocity = step.velocity;
    inspection.t = step.t;
    inspection.dynamics = dynamics_view_of(step);
    evaluate(inspection, spectrum);
    return inspection;
}

Inspection inspect_as_given(const Lesson& lesson, CoordinateChoice choice, Spectrum spectrum) {
    Inspection inspection;
    inspection.moment = tr("as given");
    inspection.choice = choice;
    inspection.state = start_state(lesson.mechanism);
    inspection.velocity = start_motion(lesson.mechanism);
    inspection.t = start_time(lesson);
    auto system = std::make_shared<System>(
        lesson.mechanism, selection_of(lesson, static_cast<int>(lesson.order.size())));
    system->choose_rows(inspection.state);
    inspection.system = system;
    evaluate(inspection, spectrum);
    return inspection;
}

namespace {

/// State and velocity to which masses and forces lead from an assembled start.
void simulate_to(const Lesson& lesson, const State& start, Inspection& inspection) {
    if (inspection.t < 0.0) {
        throw PoseNotReached(lesson.file_name + ": " + tr("there is no motion before the start at 0 s"));
    }
    const DynamicsRequest request = request_of(lesson);
    const SimulationSettings settings = request.settings;
    Simulation simulation(placed_at(taking_part(lesson), start), lesson.dynamics->loads, settings);
    // the same run as in `simulate` and in the story, whose steps end at the same times: the numbers are
    // equal to the last digit
    std::vector<double> times = equal_times(request.duration, request.samples);
    times.push_back(inspection.t);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    bool reached = false;
    const SimulationOutcome outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
        if (t != inspection.t) { return; }
        const Snapshot snapshot = simulation.snapshot(t, y);
        inspection.state = snapshot.state;
        inspection.velocity = snapshot.velocity;
        inspection.dynamics = dynamics_view_of(
            simulation.scene(), t, snapshot.state, snapshot.velocity,
            Energy{snapshot.kinetic, snapshot.potential});
        reached = true;
    });
    if (outcome.failure && !reached) {
        throw PoseNotReached(
            lesson.file_name + ": " + failure_text(*outcome.failure, settings, lesson.mechanism));
    }
}

/// State and velocity to which the drivers lead. @param system its rows switch on the way
void follow_to(const Lesson& lesson, const State& start, System& system, Inspection& inspection) {
    MotionTracker tracker(system, start, start_time(lesson));
    bool switched = false;
    if (!advance_along(tracker, lesson, inspection.t, switched)) {
        if (is_far_outside(lesson, inspection.t)) {
            throw far_outside(lesson, inspection.t, tracker.frame().t);
        }
        throw not_reached(lesson, system, *tracker.failure());
    }
    inspection.state = tracker.frame().state;
    inspection.velocity = tracker.frame().velocity;
}

}  // namespace

Inspection inspect_time(const Lesson& lesson, double t, CoordinateChoice choice, Spectrum spectrum) {
    const Story story(lesson, last_pose_only());
    const Step& last = story.steps().back();
    if (last.failure) { throw not_reached(lesson, last); }
    Inspection inspection;
    inspection.moment = "t = " + number_text(t, 9) + " s";
    inspection.choice = choice;
    inspection.t = t;
    auto system = std::make_shared<System>(*last.system);
    if (lesson.dynamics && !lesson.motion) {
        simulate_to(lesson, last.state, inspection);
        system->choose_rows(inspection.state);
    } else {
        follow_to(lesson, last.state, *system, inspection);
    }
    inspection.system = std::move(system);
    evaluate(inspection, spectrum);
    return inspection;
}

}  // namespace jw
