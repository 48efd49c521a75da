#include "core/statics/equilibrium.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "core/kinematics/paths/free_proof.hpp"
#include "core/motion/forces.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/newton.hpp"

namespace jw {

namespace {

// near folding, only short steps are proved
constexpr int kMostSteps = 10000;
// largest movement of a body in a step: turn [rad] or displacement [extents]
constexpr double kLongestStep = 0.2;
// a shorter step is rounding of the poses
constexpr double kSmallestStep = 1e-13;
// largest residual at which a search without progress has found its equilibrium: rounding of the loads, times
// the condition of the constraints
constexpr double kAtRest = 1e-9;
// in Newton's method, and in descent in a flat valley (a force that grows as the cube of the way: 8/27), the
// residual falls faster
constexpr double kStillFalls = 0.5;
// share of its first-order prediction that a step has to achieve (Armijo)
constexpr double kSufficient = 1e-4;
constexpr int kMostDoublings = 100;
// share of the last μ at which the search for the next one begins: a few doublings find it
constexpr double kShareOfLast = 0.125;
// number of steps that the proof rejects, each half as long as the previous one, before it is checked whether
// rounding hides the branch
constexpr int kRejectedUntilAsked = 4;
// factor by which the next step may be longer than the last one
constexpr double kGrowthOfReach = 2.0;
constexpr double kSoft = 1e-9;  // share of a matrix with which μ begins
// of loads and reactions: rounding, times the condition of the constraints
constexpr double kRoundingOfForces = 1e-12;
constexpr int kMostPolished = 20;  // Newton's method needs 4 from there on
// where nothing stops the bodies, the forces stay the same on the whole way
constexpr int kStepsBetweenLooks = 200;
constexpr double kUnchanged = 1e-6;
// number of poses whose rank is compared with that of an equilibrium, and their distance [rad, extents]
constexpr int kPosesBeside = 4;
constexpr double kBeside = 1e-2;
// errors of angles and lengths that a law reads, relative to these: at a pole, any force would be one of them
constexpr double kRoundingOfLaws = 1e-9;

}  // namespace

class EquilibriumSearch::Search {
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
          there_(std::make_unique<FreeForces>(scene, system_, t)),
          turns_(scene.mechanism.joints.size(), 0) {
        take(*here_, start);
        here_->count_turns();
        here_->find_forces();
    }

    bool go_on() {
        law_ = unbounded_law(here_->loads(), kinematics_of(here_->state()), t_, 0, kRoundingOfLaws);
        if (!law_.empty()) {
            failure_ = RestOutcome::Failure::no_value;
            return false;
        }
        const VectorX way = direction();
        if (is_found(way)) { return false; }
        failure_ = failure_after(steps_);
        if (failure_ != RestOutcome::Failure::none) { return false; }
        if (step(way)) {
            ++steps_;
            return true;
        }
        if (here_->residual() > kAtRest) {
            failure_ = is_nearest() ? RestOutcome::Failure::no_descent : RestOutcome::Failure::no_step;
        }
        return false;
    }

    RestOutcome outcome() {
        RestOutcome out;
        out.failure = failure_;
        out.law = law_;
        out.state = here_->state();
        out.loads = here_->loads();
        out.turns = turns_;
        out.freedoms = here_->freedoms();
        out.steps = steps_;
        out.residual = here_->residual();
        out.acceleration = here_->layout().motion_of(here_->state(), here_->free() * here_->push());
        if (out.failure != RestOutcome::Failure::none) { return out; }
        if (has_fewer_freedoms_beside()) {
            out.motions.is_singular = true;
        } else {
            out.motions = small_motions(*here_);
        }
        return out;
    }

private:
    bool is_nearest() const { return seek_ == Seek::nearest; }
    /// True at an equilibrium that the step `way` would not improve.
    bool is_found(const VectorX& way) {
        const double before = std::exchange(last_residual_, here_->residual());
        if (way.size() == 0 || way.isZero(0.0)) { return true; }
        return last_residual_ <= kAtRest && last_residual_ >= kStillFalls * before && !is_pushed_away_;
    }

    RestOutcome::Failure failure_after(int steps) {
        if (steps == kMostSteps) { return RestOutcome::Failure::too_many_steps; }
        if (steps % kStepsBetweenLooks != 0) { return RestOutcome::Failure::none; }
        const double before = std::exchange(looked_at_, last_residual_);
        const bool changes = std::abs(last_residual_ - before) > kUnchanged * before;
        return steps == 0 || changes ? RestOutcome::Failure::none : RestOutcome::Failure::endless;
    }

    /// True at a singular pose: more equations are independent at poses beside it.
    bool has_fewer_freedoms_beside() {
        for (int k = 1; k <= kPosesBeside && here_->freedoms() > 0; ++k) {
            // a different combination of all freedoms each time
            VectorX way = here_->free() * VectorX::LinSpaced(here_->freedoms(), 1.0, std::sqrt(2.0) * k);
            way *= (k % 2 == 0 ? kBeside : -kBeside) / here_->movement(way);
            State prediction = here_->state();
            here_->layout().advance(prediction, way);
            if (!correct(prediction)) { continue; }
            take(*there_, newton_.state());
            if (there_->rank() > here_->rank()) { return true; }
        }
        return false;
    }

    /// Takes a pose, for which the rows of p1 and p2 are chosen.
    void take(FreeForces& forces, const State& state) {
        system_.choose_rows(state);
        forces.set(state);
    }

    /// A whole step along the freedoms; zero where the forces are rounding.
    VectorX direction() {
        is_pushed_away_ = false;
        if (here_->freedoms() == 0) { return VectorX(0); }
        const MatrixX K = here_->stiffness();
        if (!is_nearest()) { return towards_rest(K); }
        const VectorX& push = here_->push();
        const VectorX downhill = K.transpose() * push;
        // at a maximum of |Nᵀ Q| every direction leads down: the step follows the forces
        return downhill.isZero(0.0) ? limited(K, push) : limited(K.transpose() * K, downhill);
    }

    /// Step with K in which each eigenvalue of its symmetric part is replaced by its absolute value: forces
    /// that grow along the step count as if they fell as fast. So the step leads along the forces.
    VectorX towards_rest(const MatrixX& K) {
        const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(MatrixX(0.5 * (K + K.transpose())));
        const VectorX& lambda = eigen.eigenvalues();
        here_->turn(eigen.eigenvectors());
        const VectorX errors = stiffness_errors(*here_, here_->free(), lambda.cwiseAbs().maxCoeff());
        VectorX push = here_->push();
        for (Eigen::Index k = 0; k < push.size(); ++k) {
            const bool is_rounding =
                std::abs(push(k)) <= kRoundingOfForces * here_->work_of_sizes(here_->free().col(k));
            // rounding would move a freedom without stiffness far; from a summit, nothing pushes it away
            if (is_rounding && lambda(k) <= errors(k)) { push(k) = 0.0; }
            is_pushed_away_ = is_pushed_away_ || (!is_rounding && lambda(k) < -errors(k));
        }
        MatrixX turned = eigen.eigenvectors().transpose() * K * eigen.eigenvectors();
        turned.diagonal() += lambda.cwiseAbs().cwiseMax(errors) - lambda;
        return limited(turned, push);
    }

    /// Solution of (A + μ I) x = b with the smallest of the μ tried, 0 first, for which no body moves by more
    /// than the longest step.
    VectorX limited(const MatrixX& A, const VectorX& b) {
        if (b.isZero(0.0)) { return b; }
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
        return correct_prediction(newton_, prediction, t_) && is_meant(system_, newton_.state(), sides_);
    }

    /// Takes the longest part of a whole step that achieves a share of its first-order prediction and stays
    /// on the branch: the forces do work on all of it, or |Nᵀ Q| falls. @return false if there is none
    bool step(const VectorX& along) {
        const VectorX columns = here_->free() * along;
        const double work = here_->push().dot(along);
        // the work of light bodies beside heavy ones cannot be compared: then Newton's method is trusted
        const bool is_rounding = std::abs(work) <= kRoundingOfForces * here_->work_of_sizes(columns);
        polished_ += is_rounding ? 1 : 0;
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
            const double work_there = there_->unbalanced().dot(columns_there);
            const bool keeps =
                is_nearest()
                    ? there_->push().norm() <= (1.0 - kSufficient * fraction) * here_->push().norm()
                    : work + work_there >= kSufficient * work || (is_rounding && polished_ <= kMostPolished);
            if (keeps && stays(prediction, columns, columns_there, fraction, rejected)) {
                std::swap(here_, there_);
                here_->count_turns();
                here_->find_forces();
                count_turns_of_joints();
                reach_ = kGrowthOfReach * fraction * movement;
                return true;
            }
        }
        system_.choose_rows(here_->state());
        return false;
    }

    /// Counts whole turns of the joints' angles: no body turns by half a turn in a step.
    void count_turns_of_joints() {
        for (std::size_t j = 0; j < turns_.size(); ++j) {
            const double change = relative_angle(still_.joints[j], here_->state()) -
                                  relative_angle(still_.joints[j], there_->state());
            if (std::abs(change) > std::numbers::pi) { turns_[j] += change > 0.0 ? -1 : 1; }
        }
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
    bool is_pushed_away_ = false;        ///< from an unstable equilibrium
    int polished_ = 0;                   ///< steps whose work is rounding
    double last_residual_ = std::numeric_limits<double>::infinity();
    double looked_at_ = 0.0;  ///< residual some steps before
    std::vector<int> turns_;  ///< of the angle of each joint
    int steps_ = 0;
    RestOutcome::Failure failure_ = RestOutcome::Failure::none;
    std::string law_;  ///< without a value at the pose
};

EquilibriumSearch::EquilibriumSearch(const Centroidal& scene, const State& start, double t, Seek seek)
    : search_(std::make_unique<Search>(scene, start, t, seek)) {}

EquilibriumSearch::~EquilibriumSearch() = default;

bool EquilibriumSearch::go_on() { return search_->go_on(); }

RestOutcome EquilibriumSearch::outcome() { return search_->outcome(); }

RestOutcome find_equilibrium(const Centroidal& scene, const State& start, double t, Seek seek) {
    EquilibriumSearch search(scene, start, t, seek);
    while (search.go_on()) {}
    return search.outcome();
}

}  // namespace jw
