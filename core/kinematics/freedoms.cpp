#include "core/kinematics/freedoms.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

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

class Follower {
public:
    Follower(const System& system, double t)
        : system_(system),
          t_(t),
          size_(extent(system.mechanism())),
          assembler_(system_),
          scaling_(scaling_of<OmegaLocal>(system_)),
          least_squares_(scaling_),
          newton_(system_),
          sides_(intended_sides(system_)) {}

    /// Follows a direction from `state`. @return the states after it, one per step
    std::vector<State> follow(State state, VectorX direction, int steps, double length) {
        std::vector<State> states;
        while (static_cast<int>(states.size()) < steps && make_unit(direction)) {
            if (!advance(state, direction, length)) { break; }
            states.push_back(state);
        }
        return states;
    }

private:
    /// Scales a direction so that its largest rotation, displacement in sizes of the machine, or θ is 1.
    bool make_unit(VectorX& direction) const {
        double largest = 0.0;
        for (const int body : system_.moving_bodies()) {
            const int column = system_.body_column(body, 3);
            largest = std::max(
                {largest, direction.segment<3>(column).norm() / size_,
                 direction.segment<3>(column + 3).norm()});
        }
        for (const int theta : system_.active_thetas()) {
            largest = std::max(largest, std::abs(direction(system_.theta_column(theta, 3))));
        }
        direction /= largest > 0.0 ? largest : 1.0;
        return largest > kNoDirection && direction.allFinite();
    }

    /// Takes a step of `length`, in pieces where necessary.
    bool advance(State& state, VectorX& direction, double length) {
        for (double left = length; left > 0.0;) {
            const double done = piece(state, direction, left);
            if (done == 0.0 || !make_unit(direction)) { return false; }
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
            newton_.start(prediction, t_);
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
        assembler_.assemble_phi_and_jacobian(state, t_);
        least_squares_.compute(assembler_.sparse_jacobian());
        least_squares_.keep_free_part(reliable_rank(least_squares_, newton_.outcome()->residual), direction);
    }

    System system_;  // a copy: rows are chosen again on the way
    double t_;
    double size_;
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    NewtonStepper<OmegaLocal> newton_;
    std::vector<int> sides_;
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
    Follower follower(system, t);
    FollowedMotion motion;
    motion.states = follower.follow(state, -direction, steps, step_turn);
    std::ranges::reverse(motion.states);
    motion.start = static_cast<int>(motion.states.size());
    motion.states.push_back(state);
    const std::vector<State> after = follower.follow(state, direction, steps, step_turn);
    motion.states.insert(motion.states.end(), after.begin(), after.end());
    motion.finite = motion.states.size() > 1;
    return motion;
}

}  // namespace jw
