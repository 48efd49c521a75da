#include "core/kinematics/freedoms.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/kinematics/paths/free_path.hpp"
#include "core/kinematics/paths/free_proof.hpp"

namespace jw {

namespace {

// a whole number of steps, up to rounding
constexpr double kOfAStep = 1e-12;
// for a step length of zero, or a tiny one: more than any path has
constexpr double kMostStepsToProve = 1e9;

std::size_t steps_to_prove(double length) {
    return static_cast<std::size_t>(
        std::min(std::ceil(kProvedLength / length - kOfAStep), kMostStepsToProve));
}

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
    FreePath path(still, state);
    const std::vector<PathPoint> before = path.follow({state, -direction}, steps, step_turn);
    const std::vector<PathPoint> after = path.follow({state, direction}, steps, step_turn);
    FollowedMotion motion;
    motion.start = static_cast<int>(before.size()) - 1;
    for (auto point = before.rbegin(); point != before.rend(); ++point) {
        motion.states.push_back(point->state);
    }
    for (std::size_t k = 1; k < after.size(); ++k) { motion.states.push_back(after[k].state); }

    motion.departure = find_departure(still, state, direction);
    // the first step of another motion does not lead along this velocity
    const std::size_t first = motion.departure ? 1 : 0;
    const std::size_t proved = steps_to_prove(step_turn);
    const bool is_proved =
        path.proves(after, step_turn, first, proved) || path.proves(before, step_turn, first, proved);
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
    // for another motion, the proof begins a step later
    const int steps = static_cast<int>(steps_to_prove(kFreedomStep)) + 1;
    return follow_free_motion(system, state, t, direction, steps, kFreedomStep);
}

}  // namespace jw
