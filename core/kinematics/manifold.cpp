#include "core/kinematics/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

constexpr int kMostSteps = 5;
constexpr double kLargestTurnOfStep = 0.2;  // [rad]; an arc of 0.2 leaves its tangent by a tenth of the step
constexpr double kLargestShift = 0.2;       // sizes of the machine
constexpr double kReached = 1e-9;           // sizes of the machine: a millionth of a pixel
// a target further off counts only by its direction; a nearer one keeps digits for the last steps
constexpr double kFar = 10.0;  // sizes of the machine
constexpr double kHuge = 1e100;
// a decrease of ½ distance² below this share of it is rounding
constexpr double kSmallestGain = 1e-13;
constexpr double kSufficient = 1e-4;  // Armijo, as in newton.cpp
// conjugate directions: as many as there are freedoms, but not more than are worth their cost in one step
constexpr int kMostDirections = 8;
constexpr double kDirectionRest = 1e-3;
// differences of gradients: truncation 1e-6, rounding 1e-16 / 1e-6
constexpr double kDifference = 1e-6;
// 1, 1/4 ... 1/64 of a step; where corrections stay proportional to it, the pose is a corner
constexpr int kMostAttempts = 4;
constexpr double kShorter = 0.25;
// quadratic convergence needs 4 from a good prediction
constexpr int kMostCorrections = 8;
// at a corner the tangent belongs to no branch: a solution near the prediction is accepted if it is about as
// far from the start
constexpr double kLargestCornerCorrection = 1.5;
constexpr double kSmallestCornerStep = 0.3;

/// Scaling with displacements in sizes of the machine, so that a small machine is moved rather than turned.
Scaling scaling_by_size(const System& system, double size) {
    Scaling scaling = scaling_of<OmegaLocal>(system);
    for (const int body : system.moving_bodies()) {
        scaling.column.segment<3>(system.body_column(body, 3)).setConstant(size);
    }
    return scaling;
}

}  // namespace

int reliable_rank(const LeastSquares& least_squares, double residual) {
    const int rank = least_squares.rank(std::max(kRankThreshold, kErrorFactor * residual));
    const bool lost = rank > 1 && least_squares.relative_pivot(rank - 1) <
                                      kLostPivotRatio * least_squares.relative_pivot(rank - 2);
    return lost ? rank - 1 : rank;
}

bool project(System& system, State& state, double t) {
    system.choose_rows(state);
    NewtonStepper<OmegaLocal> newton(system);
    newton.start(state, t);
    if (!solve(newton).converged || !is_meant(system, newton.state(), intended_sides(system))) {
        return false;
    }
    state = newton.state();
    return true;
}

Dragger::Dragger(System& system, State state, double t)
    : system_(&system),
      state_(std::move(state)),
      t_(t),
      size_(extent(system.mechanism())),
      assembler_(system),
      scaling_(scaling_by_size(system, size_)),
      least_squares_(scaling_),
      newton_(system),
      sides_(intended_sides(system)),
      trial_(state_) {
    multipliers_.setZero(scaling_.row.size());
    slope_.setZero(scaling_.column.size());
    slope_there_ = direction_ = conjugate_ = rest_ = curvature_ = step_ = slope_;
}

Vec3 Dragger::point(const State& state) const {
    const auto b = static_cast<std::size_t>(body_);
    return state.r[b] + rotation_matrix(state.p[b]) * point_local_;
}

void Dragger::factor() {
    system_->choose_rows(state_);
    assembler_.assemble_phi_and_jacobian(state_, t_);
    least_squares_.compute(assembler_.sparse_jacobian());
    const VectorX& phi = assembler_.phi();
    residual_ = phi.size() == 0 ? 0.0 : phi.cwiseQuotient(scaling_.row).cwiseAbs().maxCoeff();
    rank_ = reliable_rank(least_squares_, residual_);
}

void Dragger::keep_free_part(VectorX& scaled) {
    scaled = scaled.cwiseProduct(scaling_.column);
    least_squares_.keep_free_part(rank_, scaled);
    scaled = scaled.cwiseQuotient(scaling_.column);
}

/// Negative gradient of ½ |goal - point|² + λᵀΦ at `state`, in scaled unknowns; the multipliers λ make it a
/// free motion at the present state.
void Dragger::slope_at(const State& state, VectorX& slope) {
    assembler_.assemble_phi_and_jacobian(state, t_);
    if (least_squares_.is_sparse()) {
        slope = -assembler_.sparse_jacobian().transposed_times(multipliers_);
    } else {
        slope.noalias() = -assembler_.jacobian().transpose() * multipliers_;
    }
    const auto b = static_cast<std::size_t>(body_);
    const int column = system_->body_column(body_, 3);
    const Mat3 A = rotation_matrix(state.p[b]);
    const Vec3 pull = goal_ - state.r[b] - A * point_local_;
    slope.segment<3>(column) += pull;
    slope.segment<3>(column + 3) += point_local_.cross(A.transpose() * pull);
    slope = slope.cwiseProduct(scaling_.column);
}

/// Second derivative of the same along a free motion, by a difference of gradients.
void Dragger::curvature_along(const VectorX& direction, VectorX& curvature) {
    const double h = kDifference / direction.norm();
    step_ = h * direction.cwiseProduct(scaling_.column);
    trial_ = state_;
    assembler_.layout().advance(trial_, step_);
    slope_at(trial_, slope_there_);
    curvature = (slope_ - slope_there_) / h;
    keep_free_part(curvature);
}

/// Newton direction by conjugate gradients within the free motions; the gradient itself where the curvature
/// of the distance is negative.
void Dragger::find_direction() {
    direction_.setZero();
    rest_ = conjugate_ = slope_;
    const int most = std::min(static_cast<int>(slope_.size()) - rank_, kMostDirections);
    for (int k = 0; k < most; ++k) {
        const double rest_square = rest_.squaredNorm();
        curvature_along(conjugate_, curvature_);
        const double bend = conjugate_.dot(curvature_);
        if (bend <= kDifference * conjugate_.squaredNorm() * size_ * size_) {
            if (k == 0) { direction_ = slope_ * (kFar / slope_.norm()); }
            return;
        }
        direction_ += rest_square / bend * conjugate_;
        rest_ -= rest_square / bend * curvature_;
        if (rest_.norm() <= kDirectionRest * slope_.norm()) { return; }
        conjugate_ = rest_ + rest_.squaredNorm() / rest_square * conjugate_;
    }
}

void Dragger::shorten_direction() {
    double turn = 0.0;
    double shift = 0.0;
    for (const int body : system_->moving_bodies()) {
        const int column = system_->body_column(body, 3);
        shift = std::max(shift, direction_.segment<3>(column).norm());
        turn = std::max(turn, direction_.segment<3>(column + 3).norm());
    }
    for (const int theta : system_->active_thetas()) {
        turn = std::max(turn, std::abs(direction_(system_->theta_column(theta, 3))));
    }
    const double excess = std::max(turn / kLargestTurnOfStep, shift / kLargestShift);
    if (excess > 1.0) { direction_ /= excess; }
}

/// Newton's method on Φ from the tangent; the result is in `newton_` if it has converged.
bool Dragger::correct(double fraction, DragOutcome& outcome) {
    step_ = fraction * direction_.cwiseProduct(scaling_.column);
    trial_ = state_;
    assembler_.layout().advance(trial_, step_);
    newton_.start(trial_, t_);
    for (int k = 0; k <= kMostCorrections && !newton_.outcome(); ++k) { newton_.step(); }
    outcome.newton_iterations += newton_.outcome() ? newton_.outcome()->iterations : kMostCorrections;
    return newton_.outcome() && newton_.outcome()->converged;
}

/// Takes one step. @return false if no step brings the point nearer
bool Dragger::step(DragOutcome& outcome) {
    const Vec3 e = target_ - point(state_);
    const Vec3 way = e * (kFar * size_ / std::max(e.norm(), kFar * size_));
    goal_ = point(state_) + way;
    const double value = 0.5 * way.squaredNorm();

    // the pull, and the part of it that the constraints leave free
    multipliers_.setZero();
    slope_at(state_, slope_);
    step_ = slope_.cwiseQuotient(scaling_.column);
    least_squares_.solve_transposed(step_, rank_, multipliers_);
    slope_at(state_, slope_);
    keep_free_part(slope_);
    if (slope_.norm() == 0.0) { return false; }
    find_direction();
    shorten_direction();

    const double promise = 0.5 * slope_.dot(direction_);
    double fraction = 1.0;
    bool corner = false;
    bool has_way_out = false;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt, fraction *= kShorter) {
        if (fraction * promise <= kSmallestGain * value) { return false; }
        corner = false;
        if (!correct(fraction, outcome)) { continue; }
        const State& reached = newton_.state();
        const double there = 0.5 * (goal_ - point(reached)).squaredNorm();
        if (there > value - kSufficient * fraction * promise) { continue; }
        if (same_curve(*system_, state_, trial_, reached, sides_)) {
            accept(reached);
            return true;
        }
        corner = true;
        if (!has_way_out && leads_on(reached)) {
            has_way_out = true;
            way_out_ = reached;
        }
    }
    // corrections proportional to the step, however short: branches meet here, and none is along the tangent
    if (!corner || !has_way_out) { return false; }
    accept(way_out_);
    return true;
}

bool Dragger::leads_on(const State& reached) const {
    const double tangent = movement(*system_, state_, trial_);
    return movement(*system_, trial_, reached) <= kLargestCornerCorrection * tangent &&
           movement(*system_, state_, reached) >= kSmallestCornerStep * tangent &&
           is_meant(*system_, reached, sides_);
}

void Dragger::accept(const State& reached) {
    state_ = reached;
    residual_ = newton_.outcome()->residual;
}

DragOutcome Dragger::pull(int body, const Vec3& point_local, const Vec3& target) {
    const auto bodies = static_cast<int>(state_.r.size());
    if (body < 0 || body >= bodies) {
        throw std::invalid_argument(
            "Dragger: body " + std::to_string(body) + " of " + std::to_string(bodies));
    }
    DragOutcome outcome;
    body_ = body;
    point_local_ = point_local;
    const double largest = target.cwiseAbs().maxCoeff();
    const bool finite = point_local.allFinite() && target.allFinite();
    target_ = largest > kHuge ? Vec3(target * (kHuge / largest)) : target;
    const bool moves = finite && system_->body_column(body, 3) >= 0;
    for (int k = 0; k < kMostSteps && !outcome.blocked; ++k) {
        factor();
        outcome.freedoms = static_cast<int>(scaling_.column.size()) - rank_;
        if (!finite || (target_ - point(state_)).norm() <= kReached * size_) { break; }
        outcome.blocked = !moves || outcome.freedoms == 0 || !step(outcome);
    }
    outcome.residual = residual_;
    outcome.distance = finite ? (target_ - point(state_)).norm() : 0.0;
    return outcome;
}

}  // namespace jw
