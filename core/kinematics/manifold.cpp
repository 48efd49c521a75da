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

constexpr double kMostSteps = 5.0;
constexpr double kReached = 1e-9;  // sizes of the machine: a millionth of a pixel
constexpr double kHuge = 1e100;
// a decrease of ½ distance² below this share of it is rounding
constexpr double kSmallestGain = 1e-13;
constexpr double kSufficient = 1e-4;  // Armijo, as in newton.cpp
// 1, 1/4 ... 1/64 of a step; if corrections stay proportional to the step, the pose is a corner
constexpr int kMostAttempts = 4;
constexpr double kShorter = 0.25;
// at a corner, the tangent does not belong to any branch: a solution near the prediction is accepted if it is
// about as far from the start
constexpr double kLargestCornerCorrection = 1.5;
constexpr double kSmallestCornerStep = 0.3;

/// Scaling with displacements in sizes of the machine, so that a small machine moves instead of turning.
Scaling scaling_by_size(const System& system, double size) {
    Scaling scaling = scaling_of<OmegaLocal>(system);
    for (const int body : system.moving_bodies()) {
        scaling.column.segment<3>(system.body_column(body, 3)).setConstant(size);
    }
    return scaling;
}

}  // namespace

int rank_of_all(const LeastSquares& least_squares, double residual) {
    return least_squares.rank(std::max(kRankThreshold, kErrorFactor * residual));
}

int reliable_rank(const LeastSquares& least_squares, double residual) {
    const int rank = rank_of_all(least_squares, residual);
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
      least_squares_there_(scaling_),
      proof_(FreeProof::of(system, t)),
      trial_(state_),
      reached_(state_) {
    multipliers_.setZero(scaling_.row.size());
    slope_.setZero(scaling_.column.size());
    slope_there_ = direction_ = conjugate_ = rest_ = curvature_ = step_ = slope_;
}

Vec3 Dragger::point(const State& state) const {
    const auto b = static_cast<std::size_t>(body_);
    return state.r[b] + rotation_matrix(state.p[b]) * point_local_;
}

/// Chooses rows at a state and factors its equations, which are then in the assembler.
void Dragger::factor(const State& state, LeastSquares& least_squares) {
    system_->choose_rows(state);
    assembler_.assemble_phi_and_jacobian(state, t_);
    least_squares.compute(assembler_.sparse_jacobian());
}

/// Largest |Φ| in the assembler, scaled.
double Dragger::residual() const { return scaling_.residual_of(assembler_.phi()); }

/// Applies Newton's method to Φ from the tangent; the result is in `newton_` if it has converged.
bool Dragger::correct(double fraction, DragOutcome& outcome) {
    step_ = fraction * direction_.cwiseProduct(scaling_.column);
    trial_ = state_;
    assembler_.layout().advance(trial_, step_);
    const bool converged = correct_prediction(newton_, trial_, t_);
    outcome.newton_iterations += newton_.outcome() ? newton_.outcome()->iterations : kMostFromPrediction;
    return converged;
}

/// Takes one step. @return its share of a whole step, 0 if no step brings the point nearer
double Dragger::step(DragOutcome& outcome) {
    if (proof_) {
        const std::optional<double> proved = proved_step(outcome);
        if (proved) { return *proved; }
    }
    if (!is_factored_) { factor(state_, least_squares_); }
    is_factored_ = false;
    const Promise promise = find_way(reliable_rank(least_squares_, residual_));
    return promise.gain > 0.0 && step_along_tangent(promise, outcome) ? 1.0 : 0.0;
}

/// Takes a step that stays near its tangent, if nothing can be proved.
bool Dragger::step_along_tangent(const Promise& promise, DragOutcome& outcome) {
    double fraction = 1.0;
    bool corner = false;
    bool has_way_out = false;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt, fraction *= kShorter) {
        if (promise.is_rounding(fraction)) { return false; }
        corner = false;
        if (!correct(fraction, outcome) || !gains(fraction, promise)) { continue; }
        const State& reached = newton_.state();
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
    // corrections stay proportional to even short steps: branches meet here, and none follows the tangent
    if (!corner || !has_way_out) { return false; }
    accept(way_out_);
    return true;
}

bool Dragger::Promise::is_rounding(double fraction) const {
    // negated, so that NaN counts as rounding
    return !(fraction * gain > kSmallestGain * value);
}

/// True if the pose in `newton_` is nearer to the goal by a share of the predicted decrease.
bool Dragger::gains(double fraction, const Promise& promise) const {
    const double there = 0.5 * (goal_ - point(newton_.state())).squaredNorm();
    return there <= promise.value - kSufficient * fraction * promise.gain;
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
    double left = kMostSteps;
    proofs_left_ = proof_ ? proof_->most_steps() : 1;
    while (left > 0.0 && proofs_left_ > 0 && !outcome.blocked) {
        if (!is_factored_) {
            factor(state_, least_squares_);
            residual_ = residual();
            is_factored_ = true;
        }
        outcome.freedoms =
            static_cast<int>(scaling_.column.size()) - reliable_rank(least_squares_, residual_);
        if (!finite || (target_ - point(state_)).norm() <= kReached * size_) { break; }
        const double taken = moves && outcome.freedoms > 0 ? step(outcome) : 0.0;
        outcome.blocked = taken == 0.0 && proofs_left_ > 0;
        left -= taken;
    }
    outcome.residual = residual_;
    outcome.distance = finite ? (target_ - point(state_)).norm() : 0.0;
    return outcome;
}

}  // namespace jw
