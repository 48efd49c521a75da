#include "core/statics/equilibrium.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "core/kinematics/paths/free_proof.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/newton.hpp"

namespace jw {

namespace {

// near folding, only short steps are proved
constexpr int kMostSteps = 10000;
// largest movement of a body in a step: turn [rad] or displacement [extents]
constexpr double kLongestStep = 0.2;
// a shorter one is rounding of the poses
constexpr double kSmallestStep = 1e-13;
// residual from which on a search that gets no further has found its equilibrium: rounding of the loads,
// times the condition of the constraints
constexpr double kAtRest = 1e-9;
// Newton's method, and descent in a flat valley (a force that grows as the cube of the way: 8/27), fall
// faster
constexpr double kStillFalls = 0.5;
// share of what a step promises that it has to keep (Armijo)
constexpr double kSufficient = 1e-4;
constexpr int kMostDoublings = 100;
// of the last μ: near it, the next one is found in a few doublings
constexpr double kShareOfLast = 0.125;
constexpr int kMostCorrections = 8;
// steps that the proof rejects, each half as long as the one before, until it is asked whether rounding hides
// the branch
constexpr int kRejectedUntilAsked = 4;
// the next step may be so much longer than the last one
constexpr double kGrowthOfReach = 2.0;
// a smallest eigenvalue below this share of the largest is none to divide by
constexpr double kSoft = 1e-9;

class Search {
public:
    Search(const Centroidal& scene, const State& start, double t, Seek seek)
        : still_(at_rest(scene.mechanism, t)),
          system_(still_, everything(still_)),
          t_(t),
          seek_(seek),
          sides_(intended_sides(system_)),
          newton_(system_),
          proof_(FreeProof::of(system_, t)),
          here_(std::make_unique<FreeForces>(scene, system_, t)),
          there_(std::make_unique<FreeForces>(scene, system_, t)) {
        take(*here_, start);
        here_->count_turns();
        here_->find_forces();
    }

    RestOutcome run() {
        RestOutcome out;
        while (out.failure == RestOutcome::Failure::none && !is_found()) {
            if (out.steps == kMostSteps) {
                out.failure = RestOutcome::Failure::too_many_steps;
            } else if (step()) {
                ++out.steps;
            } else if (here_->residual() <= kAtRest) {
                break;
            } else {
                out.failure = is_nearest() ? RestOutcome::Failure::no_descent : RestOutcome::Failure::no_step;
            }
        }
        out.state = here_->state();
        out.loads = here_->loads();
        out.freedoms = here_->freedoms();
        out.residual = here_->residual();
        out.acceleration = here_->layout().motion_of(here_->state(), here_->free() * here_->push());
        if (out.failure == RestOutcome::Failure::none) { out.motions = small_motions(*here_); }
        return out;
    }

private:
    bool is_nearest() const { return seek_ == Seek::nearest; }
    /// True at an equilibrium that more steps would not improve.
    bool is_found() {
        const double before = std::exchange(last_residual_, here_->residual());
        return here_->freedoms() == 0 || last_residual_ == 0.0 ||
               (last_residual_ <= kAtRest && last_residual_ >= kStillFalls * before);
    }

    /// Takes a pose, for which the rows of p1 and p2 are chosen.
    void take(FreeForces& forces, const State& state) {
        system_.choose_rows(state);
        forces.set(state);
    }

    /// A whole step along the freedoms.
    VectorX direction() {
        const MatrixX K = here_->stiffness(2);
        const VectorX& push = here_->push();
        if (!is_nearest()) { return limited(towards_rest(K), push); }
        const VectorX downhill = K.transpose() * push;
        // where |Nᵀ Q| is largest, any way leads down: the one along the forces
        return downhill.isZero(0.0) ? limited(K, push) : limited(K.transpose() * K, downhill);
    }

    /// K, where the forces grow along the way as if they fell as fast: along each eigenvector of its
    /// symmetric part, the eigenvalue has its size. A step with it leads along the forces.
    static MatrixX towards_rest(const MatrixX& K) {
        const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(MatrixX(0.5 * (K + K.transpose())));
        const VectorX& lambda = eigen.eigenvalues();
        const double soft = kSoft * lambda.cwiseAbs().maxCoeff();
        if (lambda(0) > soft) { return K; }
        const VectorX added = lambda.cwiseAbs().cwiseMax(soft) - lambda;
        return K + eigen.eigenvectors() * added.asDiagonal() * eigen.eigenvectors().transpose();
    }

    /// Solution of (A + μ I) x = b with the smallest of the μ tried, 0 first, for which no body moves by more
    /// than the longest step.
    VectorX limited(const MatrixX& A, const VectorX& b) {
        double mu = 0.0;
        double next = std::max(kSoft * A.norm(), kShareOfLast * mu_);
        for (int k = 0; k < kMostDoublings; ++k) {
            MatrixX shifted = A;
            shifted.diagonal().array() += mu;
            const VectorX x = Eigen::PartialPivLU<MatrixX>(shifted).solve(b);
            if (x.allFinite() && here_->movement(here_->free() * x) <= kLongestStep) {
                mu_ = mu;
                return x;
            }
            if (next == 0.0) { break; }
            mu = next;
            next *= 2.0;
        }
        return b * (kLongestStep / here_->movement(here_->free() * b));
    }

    /// Applies Newton's method to Φ from the tangent; the result is in `newton_`.
    bool correct(const State& prediction) {
        newton_.start(prediction, t_);
        for (int k = 0; k <= kMostCorrections && !newton_.outcome(); ++k) { newton_.step(); }
        return newton_.outcome() && newton_.outcome()->converged &&
               is_meant(system_, newton_.state(), sides_);
    }

    /// Takes the longest part of a whole step that keeps what it promises to first order, and stays on the
    /// branch: the forces do work on all of it, or |Nᵀ Q| falls. @return false if there is none
    bool step() {
        const VectorX along = direction();
        const VectorX columns = here_->free() * along;
        const double work = here_->push().dot(along);
        const double movement = here_->movement(columns);
        int rejected = 0;
        const double first = std::min(1.0, reach_ / movement);
        for (double fraction = first; movement * fraction > kSmallestStep; fraction *= 0.5) {
            State prediction = here_->state();
            here_->layout().advance(prediction, fraction * columns);
            if (!correct(prediction)) { continue; }
            take(*there_, newton_.state());
            if (is_nearest()) { there_->find_forces(); }
            const VectorX columns_there = there_->free_part(columns);
            const double work_there = there_->force_at(there_->state()).dot(columns_there);
            const bool keeps =
                is_nearest() ? there_->push().norm() <= (1.0 - kSufficient * fraction) * here_->push().norm()
                             : work + work_there >= kSufficient * work;
            if (keeps && stays(prediction, columns, columns_there, fraction, rejected)) {
                std::swap(here_, there_);
                here_->count_turns();
                here_->find_forces();
                reach_ = kGrowthOfReach * fraction * movement;
                return true;
            }
        }
        system_.choose_rows(here_->state());
        return false;
    }

    /// True if it is proved that the step stays on its branch; where nothing can be proved, if it stays near
    /// its tangent.
    bool stays(
        const State& prediction, const VectorX& columns, const VectorX& columns_there, double fraction,
        int& rejected) {
        if (!proof_) { return true; }
        const State& from = here_->state();
        const State& to = there_->state();
        if (there_->rank() == here_->rank() && proof_->holds(
                                                   from, here_->layout().motion_of(from, columns), to,
                                                   there_->layout().motion_of(to, columns_there), fraction)) {
            return true;
        }
        if (++rejected < kRejectedUntilAsked || proof_->decides_at(from, zero_motion(still_))) {
            return false;
        }
        return same_curve(system_, from, prediction, to, sides_);
    }

    Mechanism still_;
    System system_;
    double t_;
    Seek seek_;
    std::vector<int> sides_;
    NewtonStepper<OmegaLocal> newton_;
    std::unique_ptr<FreeProof> proof_;  ///< if there are loops
    std::unique_ptr<FreeForces> here_;
    std::unique_ptr<FreeForces> there_;  ///< at the end of a step
    double reach_ = kLongestStep;        ///< movement that is tried first
    double mu_ = 0.0;                    ///< of the last step
    double last_residual_ = std::numeric_limits<double>::infinity();
};

}  // namespace

RestOutcome find_equilibrium(const Centroidal& scene, const State& start, double t, Seek seek) {
    return Search(scene, start, t, seek).run();
}

}  // namespace jw
