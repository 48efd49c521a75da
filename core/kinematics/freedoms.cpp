#include "core/kinematics/freedoms.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/kinematics/cubic_path.hpp"
#include "core/kinematics/free_proof.hpp"
#include "core/kinematics/manifold.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/newton.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// 1, 1/4, 1/16, 1/64 of a step
constexpr int kMostAttempts = 4;
constexpr double kShorter = 0.25;
// share of the predicted movement, where no curve follows the tangent
constexpr double kKeptAtCorner = 0.1;
constexpr double kLargestCornerCorrection = 1.5;
constexpr double kNoDirection = 1e-12;  // relative to the one before: no part of it is free any more
// An equation holds: rounding of a pose far from the origin, and far less than what a motion of first order
// has left it by after kProvedLength.
constexpr double kHoldsAlong = 1e-11;
// 1/1024 of a step: a start where branches cross needs kCrossing
constexpr int kMostHalvings = 10;

double steps_to_prove(double length) { return std::ceil(kProvedLength / length - kNoDirection); }

/// Pose of a free motion and its tangent there, in columns, of size 1.
struct PathPoint {
    State state;
    VectorX direction;
};

/// Its drivers stand still, so that time is the length of the path.
class Follower {
public:
    Follower(const System& system, const State& start)
        : system_(system),
          size_(extent(system.mechanism())),
          assembler_(system_),
          scaling_(scaling_of<OmegaLocal>(system_)),
          least_squares_(scaling_),
          newton_(system_),
          sides_(intended_sides(system_)),
          proof_(system_, StepProof::LeftFree::kept) {
        assembler_.assemble_phi_and_jacobian(start, 0.0);
        const VectorX misfit = assembler_.phi().cwiseQuotient(scaling_.row);
        holds_ =
            std::max(kHoldsAlong, kErrorFactor * (misfit.size() > 0 ? misfit.cwiseAbs().maxCoeff() : 0.0));
    }

    /// Follows a direction from `point`. @return the point, and those after it, one per step
    std::vector<PathPoint> follow(PathPoint point, int steps, double length) {
        const bool leads_anywhere = make_unit(point.direction);
        std::vector<PathPoint> path{point};
        while (leads_anywhere && static_cast<int>(path.size()) <= steps && advance(point, length)) {
            path.push_back(point);
        }
        return path;
    }

    /// True if it is proved that a motion of kProvedLength leads along `path`, whose points are `length`
    /// apart, from its point `first` on.
    bool proves(const std::vector<PathPoint>& path, double length, std::size_t first) {
        const double steps = steps_to_prove(length);
        if (!(static_cast<double>(first) + steps < static_cast<double>(path.size()))) { return false; }
        for (std::size_t k = first; k < first + static_cast<std::size_t>(steps); ++k) {
            const double t = static_cast<double>(k) * length;
            if (!proves(path[k], t, path[k + 1], t + length, 0)) { return false; }
        }
        return true;
    }

private:
    /// Scales a direction so that its largest rotation, displacement in sizes of the machine, or θ is 1.
    bool make_unit(VectorX& direction) const {
        const double largest = largest_part(system_, direction, size_);
        direction /= largest > 0.0 ? largest : 1.0;
        return largest > kNoDirection && direction.allFinite();
    }

    /// Takes a step of `length`, in pieces where necessary.
    bool advance(PathPoint& point, double length) {
        for (double left = length; left > 0.0;) {
            const double done = piece(point.state, point.direction, left);
            if (done == 0.0 || !make_unit(point.direction)) { return false; }
            left = done < 0.99 * left ? left - done : 0.0;
        }
        return true;
    }

    /// Takes a piece of a step. @return its length, 0 if none can be taken; `direction` becomes the tangent
    /// at its end
    double piece(State& state, VectorX& direction, double length) {
        system_.choose_rows(state);
        State way_out;
        double way_out_length = 0.0;
        for (int attempt = 0; attempt < kMostAttempts; ++attempt, length *= kShorter) {
            State prediction = state;
            assembler_.layout().advance(prediction, length * direction);
            newton_.start(prediction, 0.0);
            if (!solve(newton_).converged) { continue; }
            const State& reached = newton_.state();
            if (same_curve(system_, state, prediction, reached, sides_)) {
                state = reached;
                keep_free_part(state, direction);
                return length;
            }
            if (way_out_length == 0.0 && leads_on(state, prediction, reached)) {
                way_out = reached;
                way_out_length = length;
            }
        }
        if (way_out_length == 0.0) { return 0.0; }
        direction = difference(state, way_out);
        state = way_out;
        keep_free_part(state, direction);
        return way_out_length;
    }

    bool leads_on(const State& from, const State& prediction, const State& reached) const {
        const double promised = movement(system_, from, prediction);
        return movement(system_, prediction, reached) <= kLargestCornerCorrection * promised &&
               movement(system_, from, reached) >= kKeptAtCorner * promised &&
               is_meant(system_, reached, sides_);
    }

    VectorX difference(const State& from, const State& to) const {
        Motion motion = zero_motion(system_.mechanism());
        for (const int body : system_.moving_bodies()) {
            const auto b = static_cast<std::size_t>(body);
            motion.r_dot[b] = to.r[b] - from.r[b];
            motion.omega_local[b] = turn_local_between(from.p[b], to.p[b]);
        }
        for (const int theta : system_.active_thetas()) {
            const auto k = static_cast<std::size_t>(theta);
            motion.theta_dot[k] = to.theta[k] - from.theta[k];
        }
        return assembler_.layout().columns_of(from, motion);
    }

    /// Projects the direction onto the free motions at `state`; ω' is kept in body components.
    void keep_free_part(const State& state, VectorX& direction) {
        assembler_.assemble_phi_and_jacobian(state, 0.0);
        least_squares_.compute(assembler_.sparse_jacobian());
        least_squares_.keep_free_part(reliable_rank(least_squares_, newton_.outcome()->residual), direction);
    }

    bool proves(const PathPoint& from, double t_from, const PathPoint& to, double t_to, int halvings) {
        const Motion velocity = assembler_.layout().motion_of(from.state, from.direction);
        const Motion velocity_there = assembler_.layout().motion_of(to.state, to.direction);
        const PathEnd begin{t_from, &from.state, &velocity};
        const PathEnd end{t_to, &to.state, &velocity_there};
        if (!satisfies(assembler_, to.state, 0.0, holds_)) { return false; }
        if (proof_.holds(begin, end)) { return true; }
        const State between = middle_of(system_, begin, end);
        if (t_from == 0.0 && t_to <= kCrossing) { return satisfies(assembler_, between, 0.0, kCrossed); }
        if (halvings == kMostHalvings) { return false; }

        system_.choose_rows(between);
        newton_.start(between, 0.0);
        if (!solve(newton_).converged || !is_meant(system_, newton_.state(), sides_)) { return false; }
        PathPoint middle{newton_.state(), 0.5 * (from.direction + to.direction)};
        keep_free_part(middle.state, middle.direction);
        const double t = 0.5 * (t_from + t_to);
        return proves(from, t_from, middle, t, halvings + 1) && proves(middle, t, to, t_to, halvings + 1);
    }

    System system_;  // a copy: rows are chosen again on the way
    double size_;
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    NewtonStepper<OmegaLocal> newton_;
    std::vector<int> sides_;
    StepProof proof_;
    double holds_ = kHoldsAlong;
};

}  // namespace

FollowedMotion follow_free_motion(
    const System& system, const State& state, double t, const VectorX& direction, int steps,
    double step_turn) {
    if (direction.size() != system.columns(OmegaLocal::kAngular)) {
        throw std::invalid_argument(
            "follow_free_motion: direction has " + std::to_string(direction.size()) + " entries, expected " +
            std::to_string(system.columns(OmegaLocal::kAngular)));
    }
    const Mechanism mechanism = at_rest(system.mechanism(), t);
    System still(mechanism, system.selection());
    still.inherit_rows(system);
    Follower follower(still, state);
    const std::vector<PathPoint> before = follower.follow({state, -direction}, steps, step_turn);
    const std::vector<PathPoint> after = follower.follow({state, direction}, steps, step_turn);
    FollowedMotion motion;
    motion.start = static_cast<int>(before.size()) - 1;
    for (auto point = before.rbegin(); point != before.rend(); ++point) {
        motion.states.push_back(point->state);
    }
    for (std::size_t k = 1; k < after.size(); ++k) { motion.states.push_back(after[k].state); }

    motion.departure = find_departure(still, state, direction);
    // the first step of a motion beside it does not lead along the velocity
    const std::size_t first = motion.departure ? 1 : 0;
    const bool is_proved =
        follower.proves(after, step_turn, first) || follower.proves(before, step_turn, first);
    if (motion.departure) {
        motion.verdict = FreedomVerdict::first_order;
        motion.has_motion_beside = is_proved;
    } else if (is_proved) {
        motion.verdict = FreedomVerdict::finite;
    }
    return motion;
}

FreedomJudgement judge_free_motion(
    const System& system, const State& state, double t, const VectorX& direction) {
    // beside a motion of first order the proof begins a step later
    const int steps = static_cast<int>(steps_to_prove(kFreedomStep)) + 1;
    return follow_free_motion(system, state, t, direction, steps, kFreedomStep);
}

}  // namespace jw
