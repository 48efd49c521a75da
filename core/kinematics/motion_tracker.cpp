#include "core/kinematics/motion_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "core/kinematics/driven_frames.hpp"

namespace jw {

namespace {

// number of halvings of a step before it is checked whether rounding hides the branch
constexpr int kMostRejected = 4;
// steps of one interval: a motion that takes more comes too near to a singular pose, or leads too far
constexpr int kMostTried = 50000;
// shortest steps, as shares of an interval; the first one is 10^-14
constexpr double kShortest = 0x1p-46;
constexpr double kShortestFree = 0x1p-12;
// growth of a step after one that was proved: more would often be rejected
constexpr double kGrowth = 1.5;
// corrections of a pose near a change point: halvings from 1e-7, where Newton's method may stop there, to
// rounding
constexpr int kMostCorrections = 30;
// where an equation is lost, a larger correction is mostly error [rad, or units of length]
constexpr double kLargestCorrection = 1e-6;
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
      sides_(intended_sides(system)),
      angles_(system.mechanism()),
      proof_(system) {
    for (const DriverConstraint& d : system.drivers()) {
        system.mechanism().drivers[at(d.driver)].function.append_kinks(kinks_);
    }
    std::ranges::sort(kinks_);
    frame_.t = t;
    frame_.state = std::move(state);
    frame_.velocity = start_motion(system.mechanism());
    frame_.acceleration = zero_motion(system.mechanism());
    frame_.rows_switched = system_->choose_rows(frame_.state);
    if (with_accelerations && DrivenFrames::can_follow(system)) {
        quick_ = std::make_unique<DrivenFrames>(system);
    }
    analyse(0.0);
    if (full_rank_ < system.columns(OmegaLocal::kAngular)) { rank_beside_ = rank_beside(); }
    frame_.change_point = is_at_change_ || full_rank_ < rank_beside_;
    angles_.begin(t, frame_.state, frame_.velocity, frame_.acceleration);
    frame_.turns = angles_.turns();
    restart_quick_way();
}

MotionTracker::~MotionTracker() = default;

/// Uses quick steps again if the rows are sound again after a full step.
void MotionTracker::restart_quick_way() {
    quick_is_sound_ = quick_ && !is_at_change_ && frame_.velocity_verdict.unique &&
                      frame_.velocity_verdict.consistent && frame_.acceleration_verdict.consistent &&
                      quick_->start(frame_.state, frame_.velocity, frame_.acceleration, frame_.t);
}

/// Corrects the pose from Newton's tolerance to rounding. Near a change point each correction must halve the
/// residual; if an equation is lost, no correction may be large.
void MotionTracker::polish(bool is_lost) {
    for (int k = 0; k < kMostCorrections; ++k) {
        const double residual = kinematics_.residual();
        State corrected = kinematics_.corrected_state();
        if (is_lost && movement(*system_, frame_.state, corrected) > kLargestCorrection) { return; }
        std::swap(frame_.state, corrected);
        kinematics_.set_state(frame_.state, frame_.t);
        if (!is_at_change_) { return; }
        if (kinematics_.residual() > 0.5 * residual) {
            frame_.state = std::move(corrected);
            kinematics_.set_state(frame_.state, frame_.t);
            return;
        }
    }
}

/// @param h time since the velocities and accelerations of the frame [s]
void MotionTracker::analyse(double h) {
    const Motion expected = after(*system_, frame_.velocity, frame_.acceleration, is_at_change_ ? 0.0 : h);
    kinematics_.set_state(frame_.state, frame_.t);
    full_rank_ = std::max(full_rank_, kinematics_.rank());
    const bool is_lost = kinematics_.last_pivot_ratio() < kLostPivotRatio;
    is_at_change_ =
        kinematics_.rank() < full_rank_ || is_lost || kinematics_.last_pivot_ratio() < kChangePointRatio;
    frame_.change_point = is_at_change_ || kinematics_.rank() < rank_beside_;

    polish(is_lost);
    if (is_lost) {
        path_velocity_ = kinematics_.solve_velocity(expected).velocity;
        kinematics_.leave_out_weakest();
    }

    // nearest to the expected velocity: at a change point, this is the tangent of the current branch
    VelocityOutcome velocity = kinematics_.solve_velocity(expected);
    frame_.velocity = std::move(velocity.velocity);
    frame_.velocity_verdict = velocity.verdict;
    if (!is_lost) { path_velocity_ = frame_.velocity; }
    if (!with_accelerations_) { return; }
    AccelerationOutcome acceleration = kinematics_.solve_acceleration(frame_.velocity);
    frame_.acceleration = std::move(acceleration.acceleration);
    frame_.acceleration_verdict = acceleration.verdict;
    if (is_at_change_ && !acceleration.verdict.consistent) { follow_branch(); }
}

/// Corrects the velocity at a change point. There the velocity equations do not determine the tangent, but
/// accelerations exist only along the branches: the free part of the velocity is scaled by secant steps until
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

bool MotionTracker::is_proved(
    const MotionFrame& from, const Motion& velocity, const MotionFrame& to, const Motion& to_velocity) {
    return proof_.holds({from.t, &from.state, &velocity}, {to.t, &to.state, &to_velocity});
}

/// Takes a quick step. Verdicts remain those of the last full step: sound rows have full rank.
MotionTracker::Quick MotionTracker::try_quick_step(double h) {
    if (!quick_is_sound_ || !quick_->advance(frame_.t + h)) { return Quick::declined; }
    reached_ = frame_;
    reached_.t = frame_.t + h;
    quick_->write(reached_.state, reached_.velocity, reached_.acceleration);
    // a proof of all bodies keeps the branch
    const auto is_on_branch = [&] {
        return proof_.covers_all() || !find_wrong_branch(*system_, reached_.state, sides_);
    };
    if (!is_proved(frame_, path_velocity_, reached_, reached_.velocity) || !is_on_branch()) {
        quick_->retreat();
        return Quick::rejected;
    }
    std::swap(frame_, reached_);
    path_velocity_ = frame_.velocity;
    frame_.rows_switched = system_->choose_rows(frame_.state) || frame_.rows_switched;
    return Quick::accepted;
}

bool MotionTracker::try_step(double h) {
    const Quick quick = try_quick_step(h);
    if (quick != Quick::declined) { return quick == Quick::accepted; }
    if (!try_thorough_step(h, system_->drivers().empty() ? Way::tangent : Way::proved)) { return false; }
    restart_quick_way();
    return true;
}

/// Finds the pose at `frame_.t + h` by Newton's method from the prediction; the result is in `newton_`.
bool MotionTracker::find_pose(double h, Way way) {
    MotionFrame base = frame_;
    if (way == Way::proved) { base.velocity = path_velocity_; }
    // at a change point the rows do not determine accelerations: predict along the tangent alone
    if (is_at_change_) { base.acceleration = zero_motion(system_->mechanism()); }
    const State prediction = predicted(*system_, base, h);
    // rows are chosen between solves: after a large step the kept pair may have lost rank
    frame_.rows_switched = system_->choose_rows(prediction) || frame_.rows_switched;
    newton_.start(prediction, frame_.t + h);
    const NewtonOutcome outcome = solve(newton_);
    if (!outcome.converged) {
        failure_ = PositionFailure{
            is_at_change_ ? FailureCause::singular : FailureCause::no_convergence,
            outcome.largest_row,
            outcome.largest_value,
            outcome.residual,
            0.0,
            outcome.iterations,
            std::nullopt,
            frame_.t + h};
        return false;
    }
    // nothing is proved about motions that are left free
    const bool has_full_rank = full_rank_ >= system_->columns(OmegaLocal::kAngular);
    const bool is_good = way == Way::proved && has_full_rank
                             ? is_meant(*system_, newton_.state(), sides_)
                             : same_curve(*system_, frame_.state, prediction, newton_.state(), sides_);
    if (!is_good) {
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
    return true;
}

bool MotionTracker::try_thorough_step(double h, Way way) {
    if (!find_pose(h, way)) { return false; }
    const MotionFrame before = frame_;
    const Motion velocity_before = path_velocity_;
    const bool was_at_change = is_at_change_;
    frame_.t += h;
    frame_.state = newton_.state();
    frame_.rows_switched = system_->choose_rows(frame_.state) || frame_.rows_switched;
    analyse(h);
    const bool is_good = way == Way::proved     ? is_proved(before, velocity_before, frame_, path_velocity_)
                         : way == Way::crossing ? satisfies_between(before, frame_)
                                                : true;
    if (!is_good) {
        failure_ = PositionFailure{FailureCause::singular, 0, 0.0, 0.0, 0.0, 0, std::nullopt, frame_.t};
        const bool rows_switched = frame_.rows_switched;
        frame_ = before;
        frame_.rows_switched = rows_switched;
        path_velocity_ = velocity_before;
        is_at_change_ = was_at_change;
        return false;
    }
    failure_.reset();
    return true;
}

bool MotionTracker::advance_to(double t) {
    frame_.substeps = 0;
    frame_.tries = 0;
    frame_.rows_switched = false;
    const double from = frame_.t;
    const auto go_to_kink = [&](double kink) { return (kink - from) * (t - kink) <= 0.0 || reach(kink); };
    const bool reached = t > from ? std::ranges::all_of(kinks_, go_to_kink)
                                  : std::ranges::all_of(kinks_.rbegin(), kinks_.rend(), go_to_kink);
    return reached && reach(t);
}

/// False if drivers leave several bodies free together: then nothing is proved, and the motion is followed
/// along its tangent.
bool MotionTracker::is_determined() {
    return full_rank_ >= system_->columns(OmegaLocal::kAngular) ||
           !proof_.leaves_bodies_free({frame_.t, &frame_.state, &path_velocity_});
}

/// True if there are drivers, and the functions of all of them are constant from here to `t`.
bool MotionTracker::stands_still_until(double t) const {
    const double from = std::min(frame_.t, t);
    const double to = std::max(frame_.t, t);
    const auto stands = [&](const DriverConstraint& d) {
        // a bound of |f'|: equal values at both ends do not show that nothing moves between them
        return system_->mechanism().drivers[at(d.driver)].function.taylor_bounds(from, to)[1] == 0.0;
    };
    return !system_->drivers().empty() && std::ranges::all_of(system_->drivers(), stands);
}

void MotionTracker::follow_angles() {
    angles_.reach(frame_.t, frame_.state, frame_.velocity, frame_.acceleration);
    frame_.turns = angles_.turns();
}

bool MotionTracker::reach(double t) {
    const auto is_there = [&] { return std::abs(t - frame_.t) <= 1e-12 * std::max(1.0, std::abs(t)); };
    const bool waits = is_start_ && stands_still_until(t);
    if (is_start_ && !is_there() && !system_->drivers().empty() && !waits) {
        is_driven_ = is_determined();
        if (!is_driven_ && frame_.change_point && cross(t)) {
            // at a singular start fewer equations are independent than after it
            ++frame_.substeps;
            follow_angles();
            is_driven_ = is_determined();
        }
        if (!is_driven_ && full_rank_ < rank_beside_) {
            // drivers determine less here than beside the start: several branches may continue, or none
            explain_end(t);
            return false;
        }
    }
    is_start_ = is_start_ && (is_there() || waits);
    if (!is_driven_) { step_ = HUGE_VAL; }
    const double shortest = (is_driven_ ? kShortest : kShortestFree) * std::abs(t - frame_.t);
    int rejected = 0;
    for (int tried = 0; !is_there(); ++tried) {
        if (tried >= kMostTried) {  // nothing is known about the poses beyond
            failure_ = PositionFailure{};
            failure_->t = frame_.t;
            return false;
        }
        const double whole = t - frame_.t;
        const double h = std::copysign(std::min(std::abs(whole), step_), whole);
        ++frame_.tries;
        if (try_step(h)) {
            ++frame_.substeps;
            follow_angles();
            is_crossing_ = false;
            if (step_ < HUGE_VAL) { remember(); }
            if (std::abs(h) == step_) { step_ *= is_driven_ ? kGrowth : 2.0; }
            continue;
        }
        step_ = 0.5 * std::abs(h);
        const bool goes_on = step_ > shortest && frame_.t + h != frame_.t;
        if (goes_on && (++rejected < kMostRejected || !is_driven_)) { continue; }
        rejected = 0;
        if (goes_on && is_decided()) { continue; }
        if (!is_driven_ || !cross(t)) {
            explain_end(t);
            return false;
        }
        ++frame_.substeps;
        follow_angles();
        step_ = HUGE_VAL;
        latest_.clear();
    }
    frame_.t = t;
    failure_.reset();
    return true;
}

}  // namespace jw
