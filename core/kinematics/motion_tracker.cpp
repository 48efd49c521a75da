#include "core/kinematics/motion_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "core/kinematics/driven_frames.hpp"

namespace jw {

namespace {

// 2^-12 of a frame: where such a step fails, the motion ends
constexpr double kSmallestStep = 1.0 / 4096.0;
// the tangent is a few thousandths off at first: four secant steps reach rounding, the rest are reserve
constexpr int kMostSecantSteps = 8;
constexpr double kFirstSecantStep = 1e-3;

State predicted(const System& system, const MotionFrame& frame, double h) {
    State state = frame.state;
    const double half_square = 0.5 * h * h;
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        state.r[b] += h * frame.velocity.r_dot[b] + half_square * frame.acceleration.r_dot[b];
        state.p[b] = turned_local(
            state.p[b], h * frame.velocity.omega_local[b] + half_square * frame.acceleration.omega_local[b]);
    }
    for (const int theta : system.active_thetas()) {
        const auto k = static_cast<std::size_t>(theta);
        state.theta[k] += h * frame.velocity.theta_dot[k] + half_square * frame.acceleration.theta_dot[k];
    }
    return state;
}

/// Computes motion + h * rate.
Motion after(const System& system, const Motion& motion, const Motion& rate, double h) {
    Motion sum = motion;
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        sum.r_dot[b] += h * rate.r_dot[b];
        sum.omega_local[b] += h * rate.omega_local[b];
    }
    for (const int theta : system.active_thetas()) {
        const auto k = static_cast<std::size_t>(theta);
        sum.theta_dot[k] += h * rate.theta_dot[k];
    }
    return sum;
}

}  // namespace

MotionTracker::MotionTracker(System& system, State state, double t, bool with_accelerations)
    : system_(&system),
      with_accelerations_(with_accelerations),
      newton_(system),
      kinematics_(system),
      sides_(intended_sides(system)) {
    frame_.t = t;
    frame_.state = std::move(state);
    frame_.velocity = start_motion(system.mechanism());
    frame_.acceleration = zero_motion(system.mechanism());
    frame_.rows_switched = system_->choose_rows(frame_.state);
    if (with_accelerations && DrivenFrames::can_follow(system)) {
        quick_ = std::make_unique<DrivenFrames>(system);
    }
    analyse(0.0);
    restart_quick_way();
}

MotionTracker::~MotionTracker() = default;

/// Resumes quick steps where the rows are sound again after a full step.
void MotionTracker::restart_quick_way() {
    quick_is_sound_ = quick_ && !frame_.change_point && frame_.velocity_verdict.unique &&
                      frame_.velocity_verdict.consistent && frame_.acceleration_verdict.consistent &&
                      quick_->start(frame_.state, frame_.velocity, frame_.acceleration, frame_.t);
}

/// @param h time since the velocities and accelerations of the frame [s]
void MotionTracker::analyse(double h) {
    const Motion expected =
        after(*system_, frame_.velocity, frame_.acceleration, frame_.change_point ? 0.0 : h);
    kinematics_.set_state(frame_.state, frame_.t);
    full_rank_ = std::max(full_rank_, kinematics_.rank());
    if (kinematics_.last_pivot_ratio() < kLostPivotRatio) { kinematics_.leave_out_weakest(); }
    frame_.change_point =
        kinematics_.rank() < full_rank_ || kinematics_.last_pivot_ratio() < kChangePointRatio;

    if (!frame_.change_point) {
        frame_.state = kinematics_.corrected_state();
        kinematics_.set_state(frame_.state, frame_.t);
    }

    // nearest to the expected velocity: at a change point this is the tangent of the current branch
    VelocityOutcome velocity = kinematics_.solve_velocity(expected);
    frame_.velocity = std::move(velocity.velocity);
    frame_.velocity_verdict = velocity.verdict;
    if (!with_accelerations_) { return; }
    AccelerationOutcome acceleration = kinematics_.solve_acceleration(frame_.velocity);
    frame_.acceleration = std::move(acceleration.acceleration);
    frame_.acceleration_verdict = acceleration.verdict;
    if (frame_.change_point && !acceleration.verdict.consistent) { follow_branch(); }
}

/// Corrects the velocity at a change point. There the velocity equations do not determine the tangent, but
/// accelerations exist along the branches only: the free part of the velocity is scaled by secant steps until
/// γ is consistent.
void MotionTracker::follow_branch() {
    const Motion bound = kinematics_.solve_velocity(zero_motion(system_->mechanism())).velocity;
    const Motion free = after(*system_, frame_.velocity, bound, -1.0);
    const int row = frame_.acceleration_verdict.worst_row;
    double scale_before = 0.0;
    double miss_before = 0.0;
    double scale = 1.0;
    for (int k = 0; k < kMostSecantSteps && std::isfinite(scale); ++k) {
        const Motion velocity = after(*system_, bound, free, scale);
        AccelerationOutcome acceleration = kinematics_.solve_acceleration(velocity);
        const double miss = kinematics_.miss(row);
        if (acceleration.verdict.residual < frame_.acceleration_verdict.residual) {
            frame_.velocity = velocity;
            frame_.acceleration = std::move(acceleration.acceleration);
            frame_.acceleration_verdict = acceleration.verdict;
        }
        const double next =
            k == 0 ? 1.0 + kFirstSecantStep : scale - miss * (scale - scale_before) / (miss - miss_before);
        scale_before = scale;
        miss_before = miss;
        scale = next;
    }
}

/// Takes a quick step. Verdicts remain those of the last full step: sound rows have full rank.
bool MotionTracker::try_quick_step(double h) {
    if (!quick_is_sound_ || !quick_->advance(frame_.t + h)) { return false; }
    reached_ = frame_;
    quick_->write(reached_.state, reached_.velocity, reached_.acceleration);
    if (find_wrong_branch(*system_, reached_.state, sides_)) { return false; }
    std::swap(frame_, reached_);
    frame_.t += h;
    frame_.rows_switched = system_->choose_rows(frame_.state) || frame_.rows_switched;
    return true;
}

bool MotionTracker::try_step(double h) {
    if (try_quick_step(h)) { return true; }
    if (!try_thorough_step(h)) { return false; }
    restart_quick_way();
    return true;
}

bool MotionTracker::try_thorough_step(double h) {
    // at a change point accelerations are not determined by the rows: predict along the tangent alone
    MotionFrame base = frame_;
    if (frame_.change_point) { base.acceleration = zero_motion(system_->mechanism()); }
    const State prediction = predicted(*system_, base, h);
    // between solves: after a large step the kept pair may have lost rank
    frame_.rows_switched = system_->choose_rows(prediction) || frame_.rows_switched;
    newton_.start(prediction, frame_.t + h);
    const NewtonOutcome outcome = solve(newton_);
    if (!outcome.converged) {
        failure_ = PositionFailure{
            frame_.change_point ? FailureCause::singular : FailureCause::no_convergence,
            outcome.largest_row,
            outcome.largest_value,
            outcome.residual,
            0.0,
            outcome.iterations,
            std::nullopt,
            frame_.t + h};
        return false;
    }
    if (!same_curve(*system_, frame_.state, prediction, newton_.state(), sides_)) {
        const auto wrong = find_wrong_branch(*system_, newton_.state(), sides_);
        failure_ = PositionFailure{
            wrong ? FailureCause::wrong_branch : FailureCause::singular,
            outcome.largest_row,
            movement(*system_, prediction, newton_.state()),
            outcome.residual,
            0.0,
            outcome.iterations,
            wrong,
            frame_.t + h};
        return false;
    }
    frame_.t += h;
    frame_.state = newton_.state();
    frame_.rows_switched = system_->choose_rows(frame_.state) || frame_.rows_switched;
    analyse(h);
    failure_.reset();
    return true;
}

void MotionTracker::explain_end(double t) {
    // one small step beyond a dead end the gap is too small for a verdict: whether the parts can meet is
    // determined at `t`
    PositionFailure there = diagnose(*system_, frame_.state, frame_.state, t, failure_->iterations);
    if (there.cause == FailureCause::cannot_close) { failure_ = std::move(there); }
}

bool MotionTracker::advance_to(double t) {
    const double whole = t - frame_.t;
    frame_.substeps = 0;
    frame_.rows_switched = false;
    double h = whole;
    while (std::abs(t - frame_.t) > 1e-12 * std::max(1.0, std::abs(t))) {
        if (std::abs(h) > std::abs(t - frame_.t)) { h = t - frame_.t; }
        if (try_step(h)) {
            ++frame_.substeps;
            h *= 2.0;
            continue;
        }
        h *= 0.5;
        if (std::abs(h) < kSmallestStep * std::abs(whole)) {
            explain_end(t);
            return false;
        }
    }
    frame_.t = t;
    return true;
}

}  // namespace jw
