#include "core/poses/newton.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

namespace {

// rounding of r + A s' is a few 1e-16 of the coordinates; a hundred times that leaves room for sums
constexpr double kTolerance = 1e-13;
// threshold for the rank in an iteration: rows that are redundant at the solution look independent by about
// the residual
constexpr double kNewtonThreshold = 1e-9;
constexpr double kLargestThreshold = 1e-2;
// a truncated step is taken if it is predicted to remove nine tenths of the residual
constexpr double kPromisedRest = 0.1;
// near the solution, a good step increases residuals by at most a small factor; a step along directions that
// are independent only by rounding increases them, for example, from 1e-8 to the size of the machine
constexpr double kNear = 1e-3;
constexpr double kLargestGrowth = 10.0;
// an iteration that still removes a tenth of the residual has not stalled: where branches cross, residuals
// fall to a quarter per step, but by half only while one part of the error takes over from another
constexpr double kStalled = 0.9;
// Armijo's condition: a ten-thousandth of the decrease that the tangent predicts is sufficient, and is above
// rounding; if a millionth of the step gives no decrease, no step in this direction does
constexpr double kSufficient = 1e-4;
constexpr double kSmallestFraction = 1e-6;
// if the rank changes for so many iterations, rounding counts as equations
constexpr int kLastReach = 20;

double largest_coordinate(const State& state) {
    double largest = 0.0;
    for (const Vec3& r : state.r) { largest = std::max(largest, r.cwiseAbs().maxCoeff()); }
    return largest;
}

}  // namespace

double residual_tolerance(const System& system, const State& start) {
    return kTolerance * std::max(1.0, largest_coordinate(start) / system.length_unit());
}

template <class C>
NewtonStepper<C>::NewtonStepper(const System& system, NewtonOptions options)
    : system_(&system),
      options_(options),
      assembler_(system, options.normalisation_rows),
      scaling_(scaling_of<C>(system, options.normalisation_rows)),
      least_squares_(scaling_) {
    right_side_.setZero(scaling_.row.size());
    delta_.setZero(scaling_.column.size());
    linear_residual_.setZero(scaling_.row.size());
    truncated_delta_ = trial_delta_ = delta_;
    trial_ = start_state(system.mechanism());
}

template <class C>
void NewtonStepper<C>::start(State state, double t) {
    state_ = std::move(state);
    t_ = t;
    iteration_ = 0;
    previous_rank_ = 0;
    reached_further_ = false;
    tolerance_ = residual_tolerance(*system_, state_);
    outcome_.reset();
}

template <class C>
NewtonStep NewtonStepper<C>::look() {
    assembler_.assemble_phi_and_jacobian(state_, t_);
    // rounding of the current coordinates, not of a start far away
    tolerance_ = std::min(tolerance_, residual_tolerance(*system_, state_));
    NewtonStep step;
    step.iteration = iteration_;
    const VectorX& phi = assembler_.phi();
    if (phi.size() == 0) { return step; }
    step.phi_norm = phi.norm();
    Eigen::Index largest = 0;
    step.residual = phi.cwiseQuotient(scaling_.row).cwiseAbs().maxCoeff(&largest);
    // comparisons ignore NaN
    if (!phi.allFinite()) { step.residual = HUGE_VAL; }
    step.largest_row = static_cast<int>(largest);
    step.largest_value = phi(largest);
    return step;
}

template <class C>
void NewtonStepper<C>::finish(const NewtonStep& step, bool converged, bool at_floor) {
    outcome_ =
        NewtonOutcome{converged, at_floor, iteration_, step.residual, step.largest_row, step.largest_value};
    if (!converged || (C::kNormalised && !options_.normalisation_rows)) { return; }
    // normalises p in an extra step: the remainder of pᵀp - 1 is below the tolerance
    for (const int body : system_->moving_bodies()) { state_.p[static_cast<std::size_t>(body)].normalize(); }
}

template <class C>
double NewtonStepper<C>::limited_fraction() const {
    if (options_.rule != StepRule::limited) { return 1.0; }
    const double turn = assembler_.layout().largest_turn(delta_);
    return turn > kLargestTurn ? kLargestTurn / turn : 1.0;
}

template <class C>
double NewtonStepper<C>::searched_fraction() {
    if (options_.rule != StepRule::line_search) { return limited_fraction(); }
    const double now = right_side_.cwiseQuotient(scaling_.row).norm();
    for (double fraction = 1.0; fraction > kSmallestFraction; fraction *= 0.5) {
        if (residual_norm_after(fraction) <= (1.0 - kSufficient * fraction) * now) { return fraction; }
    }
    return 0.0;
}

template <class C>
double NewtonStepper<C>::residual_norm_after(double fraction) {
    trial_ = state_;
    trial_delta_ = fraction * delta_;
    assembler_.layout().advance(trial_, trial_delta_);
    assembler_.assemble_phi_and_jacobian(trial_, t_);
    return assembler_.phi().cwiseQuotient(scaling_.row).norm();
}

template <class C>
int NewtonStepper<C>::solve_for_delta(double residual) {
    least_squares_.compute(assembler_.sparse_jacobian());
    right_side_ = -assembler_.phi();

    // away from the solution, redundant rows look independent by about the residual: omit them if the rest is
    // still predicted to close
    const double tied = std::clamp(10.0 * residual, kNewtonThreshold, kLargestThreshold);
    const int full_rank = least_squares_.rank(kNewtonThreshold);
    const int tied_rank = least_squares_.rank(tied);
    least_squares_.solve(right_side_, tied_rank, delta_);
    if (tied_rank == full_rank) { return full_rank; }
    assembler_.sparse_jacobian().multiply(delta_, linear_residual_);
    linear_residual_ -= right_side_;
    const double rest = linear_residual_.cwiseQuotient(scaling_.row).norm();
    const double now = right_side_.cwiseQuotient(scaling_.row).norm();
    if (rest <= kPromisedRest * now) { return tied_rank; }

    // otherwise use all independent rows (near a singular position), unless the step is large: in a loop that
    // closes only to its typed digits, such a step is rounding divided by rounding
    truncated_delta_ = delta_;
    least_squares_.solve(right_side_, full_rank, delta_);
    if (residual > kNear || residual_norm_after(limited_fraction()) < kLargestGrowth * now) {
        return full_rank;
    }
    delta_ = truncated_delta_;
    return tied_rank;
}

template <class C>
NewtonStep NewtonStepper<C>::step() {
    NewtonStep step = look();
    if (step.residual <= tolerance_) {
        step.converged = true;
        finish(step, true, false);
        return step;
    }
    // equations of a small part of the scene are included last, and their first step may increase the
    // residual
    const bool stalled = iteration_ > 0 && !reached_further_ && step.residual > kStalled * previous_residual_;
    if (stalled && step.residual <= kFloorTolerance) {
        step.converged = true;
        // within a factor of a hundred, the limit is the arithmetic (long chains, many rows)
        finish(step, true, step.residual > 100.0 * tolerance_);
        return step;
    }
    if (iteration_ >= kMostIterations || !std::isfinite(step.residual)) {
        finish(step, false, false);
        return step;
    }
    previous_residual_ = step.residual;

    step.rank = solve_for_delta(step.residual);
    reached_further_ = iteration_ > 0 && step.rank > previous_rank_ && iteration_ < kLastReach;
    previous_rank_ = step.rank;
    step.fraction = searched_fraction();
    if (step.fraction == 0.0) {
        step.converged = step.residual <= kFloorTolerance;
        finish(step, step.converged, step.converged);
        return step;
    }
    step.turn = assembler_.layout().largest_turn(delta_);
    delta_ *= step.fraction;
    step.delta_norm = delta_.norm();
    assembler_.layout().advance(state_, delta_);
    ++iteration_;
    return step;
}

template class NewtonStepper<TrueEulerParameters>;
template class NewtonStepper<ModifiedEulerParameters>;
template class NewtonStepper<OmegaLocal>;
template class NewtonStepper<OmegaGlobal>;

}  // namespace jw
