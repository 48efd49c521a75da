#include <algorithm>

#include "core/kinematics/manifold.hpp"
#include "core/poses/branches.hpp"

/// Steps of a pull that are proved to stay on their branch.
namespace jw {

namespace {

// number of steps that the proof rejects, each half as long as the previous one, before it is checked whether
// rounding hides the branch
constexpr int kRejectedUntilAsked = 4;
constexpr double kGrowthOfReach = 2.0;
// least share of a whole step: if rounding does not hide the branch, a longer one is proved
constexpr double kShortestShare = 1e-7;

}  // namespace

/// Takes the longest step that is proved to stay on its branch; the step is halved repeatedly. All equations
/// count, even those that are nearly lost.
/// @return the share of a whole step that was taken, 0 if none; nothing where branches meet, or rounding
/// hides them
std::optional<double> Dragger::proved_step(DragOutcome& outcome) {
    const Promise promise = find_way(rank_of_all(least_squares_, residual_));
    double fraction = std::min(1.0, reach_ / promise.share);
    const bool is_limited = fraction < 1.0;
    const double first = fraction;
    int rejected = 0;
    is_singular_ = false;
    reached_ = state_;
    for (; fraction == first || fraction * promise.share >= kShortestShare; fraction *= 0.5) {
        if (promise.is_rounding(fraction)) { break; }
        if (proofs_left_ <= 0) {
            reach_ = fraction * promise.share;
            return 0.0;
        }
        if (!correct(fraction, outcome) || !gains(fraction, promise)) { continue; }
        if (is_meant(*system_, newton_.state(), sides_) && is_proved(fraction)) {
            accept(reached_);
            const double taken = fraction * promise.share;
            if (rejected > 0) { reach_ = taken; }
            if (fraction == first && is_limited) { reach_ = std::min(1.0, kGrowthOfReach * reach_); }
            return rejected > 0 || is_limited ? taken : 1.0;
        }
        if (++rejected == kRejectedUntilAsked && !is_decided(state_)) { return std::nullopt; }
    }
    return is_decided(reached_) ? std::optional(0.0) : std::nullopt;
}

/// False at a pose where branches meet: fewer equations are independent than at the end of the step, or
/// rounding hides the branch.
bool Dragger::is_decided(const State& state) {
    const bool decided = !is_singular_ && proof_->decides_at(state, zero_motion(system_->mechanism()));
    // the parts of the mechanism found here are those of a singular pose, so they are discarded
    if (!decided) {
        proof_ = FreeProof::of(*system_, t_);
        reach_ = 1.0;
    }
    return decided;
}

/// Stores the pose in `newton_`, corrected to rounding, in `reached_`, and factors its equations.
/// @return their rank
int Dragger::polish() {
    reached_ = newton_.state();
    factor(reached_, least_squares_there_);
    const int rank = rank_of_all(least_squares_there_, residual());
    multipliers_ = -assembler_.phi();
    least_squares_there_.solve(multipliers_, rank, step_);
    assembler_.layout().advance(reached_, step_);
    for (const int body : system_->moving_bodies()) { reached_.p[at(body)].normalize(); }
    return rank;
}

/// True if it is proved that a free motion leads along the direction to the pose in `newton_`.
bool Dragger::is_proved(double fraction) {
    const VectorX tangent = direction_.cwiseProduct(scaling_.column);
    const int rank = polish();
    step_ = tangent;
    least_squares_there_.keep_free_part(rank, step_);
    const Motion velocity = assembler_.layout().motion_of(state_, tangent);
    const Motion velocity_there = assembler_.layout().motion_of(reached_, step_);
    --proofs_left_;
    is_singular_ = rank > rank_;
    is_factored_ = rank == rank_ && proof_->holds(state_, velocity, reached_, velocity_there, fraction);
    if (is_factored_) {
        std::swap(least_squares_, least_squares_there_);
    } else {
        system_->choose_rows(state_);
    }
    return is_factored_;
}

}  // namespace jw
