#include "app/session/claims/claim_poses.hpp"

#include <algorithm>

#include "app/session/rest/rest.hpp"
#include "app/session/story/dynamics_rows.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/sentences.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/wording/explanations.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

/// Options of a story that adds only the joints and drivers that the claims need.
StoryOptions what_claims_need(const Lesson& lesson) {
    StoryOptions options = poses_only();
    options.additions = 0;
    for (const Claim& claim : lesson.claims) {
        if (const auto* after = std::get_if<AfterAddition>(&claim.when)) {
            options.additions = std::max(options.additions, after->count);
        }
        const auto* at = std::get_if<AtTime>(&claim.when);
        if (at != nullptr && !at->by_forces) { options.additions = static_cast<int>(lesson.order.size()); }
    }
    return options;
}

bool is_at_rest(const Claim& claim) { return std::holds_alternative<AtRest>(claim.when); }

bool has_claimed_end(const Lesson& lesson) {
    return lesson.dynamics && lesson.dynamics->point && lesson.dynamics->point_at_end;
}

}  // namespace

ClaimPoses::ClaimPoses(const Lesson& lesson)
    : lesson_(&lesson), story_(lesson, what_claims_need(lesson)), scene_(scene_of(lesson)) {
    if (!claimed_times(false).empty()) { follow_motion(); }
    if (!claimed_times(true).empty() || has_claimed_end(lesson)) { follow_forces(); }
    if (std::ranges::any_of(lesson.claims, is_at_rest)) { come_to_rest(); }
}

Pose ClaimPoses::at(const Moment& moment) const {
    return std::visit(
        Overloaded{
            [&](const AsGiven&) { return as_given(); },
            [&](const AnyState&) { return as_given(); },
            [&](const AtRest&) { return at_rest_; },
            [&](const AtTime& at) { return at.by_forces ? by_forces_.at(at.t) : motion_.at(at.t); },
            [&](const AfterAddition& addition) { return after(addition.count); },
        },
        moment);
}

Pose ClaimPoses::as_given() const {
    Pose pose;
    Instant& instant = pose.instant;
    instant.state = start_state(lesson_->mechanism);
    auto system = std::make_shared<System>(
        lesson_->mechanism, selection_of(*lesson_, static_cast<int>(lesson_->order.size())));
    system->choose_rows(instant.state);
    instant.system = system;
    instant.velocity = start_motion(lesson_->mechanism);
    instant.t = start_time(*lesson_);
    instant.scene = scene_;
    return pose;
}

Pose ClaimPoses::after(int count) const {
    Pose pose = as_given();
    for (const Step& step : story_.steps()) {
        if (step.additions != count) { continue; }
        if (step.kind == Step::Kind::assembled || step.kind == Step::Kind::bodies) {
            pose.instant.system = step.system;
            pose.instant.state = step.state;
            return pose;
        }
    }
    pose.failure = failure_text(*story_.failure());
    return pose;
}

std::vector<double> ClaimPoses::claimed_times(bool by_forces) const {
    std::vector<double> times;
    for (const Claim& claim : lesson_->claims) {
        const auto* at = std::get_if<AtTime>(&claim.when);
        if (at != nullptr && at->by_forces == by_forces) { times.push_back(at->t); }
    }
    return times;
}

void ClaimPoses::follow_motion() {
    std::vector<double> times = claimed_times(false);
    // the lesson's own intervals, too: the result of a claim must not depend on the number of other claims
    const MotionPlan& plan = *lesson_->motion;
    const double last = *std::ranges::max_element(times);
    for (int k = 0; k <= plan.steps; ++k) {
        const double t = plan.from + (plan.to - plan.from) * k / plan.steps;
        if (t < last) { times.push_back(t); }
    }
    std::ranges::sort(times);
    const Pose start = after(static_cast<int>(lesson_->order.size()));
    if (!start.failure.empty()) {
        for (const double t : times) { motion_[t] = start; }
        return;
    }
    System system = *start.instant.system;
    MotionTracker tracker(system, start.instant.state, plan.from);
    const SpringTurns springs(scene_, tracker.frame().state, tracker.frame().turns);
    std::string failure;
    for (const double t : times) {
        if (failure.empty() && !tracker.advance_to(t)) { failure = failure_text(system, *tracker.failure()); }
        const MotionFrame& frame = tracker.frame();
        Pose& pose = motion_[t];
        pose.instant = instant_of(std::make_shared<System>(system), frame);
        pose.instant.t = t;
        pose.instant.scene = springs.at(frame.state, frame.turns);
        pose.change_point = frame.change_point;
        pose.failure = failure;
    }
}

void ClaimPoses::come_to_rest() {
    at_rest_ = as_given();
    RestView view;
    try {
        view = find_rest(*lesson_, {});
    } catch (const PoseNotReached& error) {
        at_rest_.failure = error.what();
        return;
    }
    at_rest_.failure = view.failure;
    at_rest_.stability = view.outcome.motions.stability;
    Instant& instant = at_rest_.instant;
    instant.state = view.instant.state;
    instant.velocity = view.instant.velocity;
    instant.acceleration = view.instant.acceleration;
    instant.centroidal_acceleration = view.instant.centroidal_acceleration;
    instant.t = 0.0;
    auto system = std::make_shared<System>(*instant.system);
    system->choose_rows(instant.state);
    instant.system = system;
    instant.scene =
        std::make_shared<const Centroidal>(scene_->mechanism, view.outcome.loads, scene_->centres);
}

/// Follows the motion by two runs over the whole duration, whatever times are claimed, so that the result at
/// one time does not depend on the others.
void ClaimPoses::follow_forces() {
    std::vector<double> times = claimed_times(true);
    times.insert(times.end(), {0.0, lesson_->dynamics->duration});
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::map<double, Instant> rough;
    std::map<double, Instant> found;
    const auto run = [&](double tolerance, std::map<double, Instant>& instants) {
        return instants_by_forces(*lesson_, {tolerance, kMostStepsUnasked}, times, instants);
    };
    std::string failure = run(kLooseRun, rough);
    if (failure.empty()) { failure = run(kTightRun, found); }
    for (const double t : times) {
        Pose& pose = by_forces_[t];
        // moments that were reached before the run ended are valid
        if (found.contains(t)) {
            pose.instant = found.at(t);
            pose.rough = rough.at(t);
        } else {
            pose.failure = failure;
        }
    }
}

}  // namespace jw
