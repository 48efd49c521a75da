#include "core/motion_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

namespace {

// a correction of a third of the step means that prediction and solution are on different curves
constexpr double kLargestCorrection = 0.3;
// 2^-12 of a frame: where this does not help, the motion ends
constexpr double kSmallestStep = 1.0 / 4096.0;
// movements below this are rounding [scene's unit, rad]
constexpr double kNoMovement = 1e-9;

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

/// Largest movement between two states, in the scene's unit of length and rad.
double movement(const System& system, const State& a, const State& b) {
    double largest = 0.0;
    for (const int body : system.moving_bodies()) {
        const auto k = static_cast<std::size_t>(body);
        largest = std::max(
            {largest, (a.r[k] - b.r[k]).norm() / system.length_unit(),
             turn_local_between(a.p[k], b.p[k]).norm()});
    }
    return largest;
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
    analyse();
}

void MotionTracker::analyse() {
    kinematics_.set_state(frame_.state, frame_.t);
    full_rank_ = std::max(full_rank_, kinematics_.rank());
    frame_.change_point =
        kinematics_.rank() < full_rank_ || kinematics_.last_pivot_ratio() < kChangePointRatio;

    // nearest to the last velocity: at a change point this is the tangent of the branch that one came on
    VelocityOutcome velocity = kinematics_.solve_velocity(frame_.velocity);
    frame_.velocity = std::move(velocity.velocity);
    frame_.velocity_verdict = velocity.verdict;
    if (!with_accelerations_) { return; }
    AccelerationOutcome acceleration = kinematics_.solve_acceleration(frame_.velocity);
    frame_.acceleration = std::move(acceleration.acceleration);
    frame_.acceleration_verdict = acceleration.verdict;
}

bool MotionTracker::try_step(double h) {
    // at a change point accelerations are not determined by the rows: predict along the tangent alone
    MotionFrame base = frame_;
    if (frame_.change_point) { base.acceleration = zero_motion(system_->mechanism()); }
    const State prediction = predicted(*system_, base, h);
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
            std::nullopt};
        return false;
    }
    const double step = movement(*system_, frame_.state, newton_.state());
    const double correction = movement(*system_, prediction, newton_.state());
    const auto wrong = find_wrong_branch(*system_, newton_.state(), sides_);
    if (wrong || correction > std::max(kLargestCorrection * step, kNoMovement)) {
        failure_ = PositionFailure{
            wrong ? FailureCause::wrong_branch : FailureCause::singular,
            outcome.largest_row,
            correction,
            outcome.residual,
            0.0,
            outcome.iterations,
            wrong};
        return false;
    }
    frame_.t += h;
    frame_.state = newton_.state();
    frame_.newton_iterations += outcome.iterations;
    frame_.rows_switched = system_->choose_rows(frame_.state) || frame_.rows_switched;
    analyse();
    failure_.reset();
    return true;
}

bool MotionTracker::advance_to(double t) {
    const double whole = t - frame_.t;
    frame_.newton_iterations = 0;
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
        if (std::abs(h) < kSmallestStep * std::abs(whole)) { return false; }
    }
    frame_.t = t;
    return true;
}

}  // namespace jw
