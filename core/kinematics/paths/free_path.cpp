#include "core/kinematics/paths/free_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/kinematics/manifold.hpp"
#include "core/kinematics/paths/cubic_path.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// 1, 1/4, 1/16, 1/64 of a step
constexpr int kMostAttempts = 4;
constexpr double kShorter = 0.25;
// share of the predicted movement, where no curve follows the tangent
constexpr double kKeptAtCorner = 0.1;
constexpr double kLargestCornerCorrection = 1.5;
constexpr double kNoDirection = 1e-12;  // relative to the previous one: no part of it is free any more
// An equation holds up to this: rounding of a pose far from the origin, and far less than the misfit of a
// motion of first order after kProvedLength.
constexpr double kHoldsAlong = 1e-11;
// 1/1024 of a step: a start where branches cross needs kCrossing
constexpr int kMostHalvings = 10;
// share of a length: steps below a millionth are shorter than what rounding hides
constexpr double kShortestOfLength = 1e-6;

}  // namespace

FreePath::FreePath(const System& system, const State& start)
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
    holds_ = std::max(kHoldsAlong, kErrorFactor * (misfit.size() > 0 ? misfit.cwiseAbs().maxCoeff() : 0.0));
}

std::vector<PathPoint> FreePath::follow(PathPoint point, int steps, double length) {
    const bool leads_anywhere = make_unit(point.direction);
    std::vector<PathPoint> path{point};
    while (leads_anywhere && static_cast<int>(path.size()) <= steps && advance(point, length)) {
        path.push_back(point);
    }
    return path;
}

bool FreePath::proves(
    const std::vector<PathPoint>& path, double length, std::size_t first, std::size_t steps) {
    if (first + steps >= path.size()) { return false; }
    for (std::size_t k = first; k < first + steps; ++k) {
        const double t = static_cast<double>(k) * length;
        if (!proves(path[k], t, path[k + 1], t + length, kMostHalvings)) { return false; }
    }
    return true;
}

bool FreePath::make_free(PathPoint& point) {
    system_.choose_rows(point.state);
    return assemble(point) && make_unit(point.direction);
}

double FreePath::take_proved_step(PathPoint& point, double length) {
    for (const double shortest = kShortestOfLength * length; length > shortest; length *= 0.5) {
        system_.choose_rows(point.state);
        PathPoint to = point;
        assembler_.layout().advance(to.state, length * point.direction);
        if (!assemble(to) || !make_unit(to.direction)) { continue; }
        Motion velocity;
        Motion velocity_there;
        if (!satisfies(assembler_, to.state, 0.0, holds_) ||
            !proof_.holds(end_of(point, length_, velocity), end_of(to, length_ + length, velocity_there))) {
            continue;
        }
        std::swap(point, to);
        length_ += length;
        return length;
    }
    return 0.0;
}

/// Moves a point to the assembled pose nearby, and its direction into the free motions there.
bool FreePath::assemble(PathPoint& point) {
    newton_.start(point.state, 0.0);
    if (!solve(newton_).converged || !is_meant(system_, newton_.state(), sides_)) { return false; }
    point.state = newton_.state();
    keep_free_part(point.state, point.direction);
    return true;
}

/// End of a step of the path, whose velocity is kept in `velocity`.
PathEnd FreePath::end_of(const PathPoint& point, double t, Motion& velocity) const {
    velocity = assembler_.layout().motion_of(point.state, point.direction);
    return {t, &point.state, &velocity};
}

/// Scales a direction so that its largest rotation, displacement in sizes of the machine, or θ is 1.
bool FreePath::make_unit(VectorX& direction) const {
    const double largest = largest_part(system_, direction, size_);
    direction /= largest > 0.0 ? largest : 1.0;
    return largest > kNoDirection && direction.allFinite();
}

/// Takes a step of `length`, in pieces if necessary.
bool FreePath::advance(PathPoint& point, double length) {
    for (double left = length; left > 0.0;) {
        const double done = piece(point.state, point.direction, left);
        if (done == 0.0 || !make_unit(point.direction)) { return false; }
        left = done < 0.99 * left ? left - done : 0.0;
    }
    return true;
}

/// Takes a piece of a step. @return its length, 0 if none can be taken; `direction` becomes the tangent at
/// its end
double FreePath::piece(State& state, VectorX& direction, double length) {
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

bool FreePath::leads_on(const State& from, const State& prediction, const State& reached) const {
    const double promised = movement(system_, from, prediction);
    return movement(system_, prediction, reached) <= kLargestCornerCorrection * promised &&
           movement(system_, from, reached) >= kKeptAtCorner * promised && is_meant(system_, reached, sides_);
}

VectorX FreePath::difference(const State& from, const State& to) const {
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
void FreePath::keep_free_part(const State& state, VectorX& direction) {
    assembler_.assemble_phi_and_jacobian(state, 0.0);
    least_squares_.compute(assembler_.sparse_jacobian());
    least_squares_.keep_free_part(reliable_rank(least_squares_, newton_.outcome()->residual), direction);
}

bool FreePath::proves(const PathPoint& from, double t_from, const PathPoint& to, double t_to, int halvings) {
    Motion velocity;
    Motion velocity_there;
    const PathEnd begin = end_of(from, t_from, velocity);
    const PathEnd end = end_of(to, t_to, velocity_there);
    if (!satisfies(assembler_, to.state, 0.0, holds_)) { return false; }
    if (proof_.holds(begin, end)) { return true; }
    PathPoint middle{middle_of(system_, begin, end), 0.5 * (from.direction + to.direction)};
    if (t_from == 0.0 && t_to <= kCrossing) { return satisfies(assembler_, middle.state, 0.0, kCrossed); }
    if (halvings == 0) { return false; }

    system_.choose_rows(middle.state);
    if (!assemble(middle)) { return false; }
    const double t = 0.5 * (t_from + t_to);
    return proves(from, t_from, middle, t, halvings - 1) && proves(middle, t, to, t_to, halvings - 1);
}

}  // namespace jw
