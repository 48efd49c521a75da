#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/shipped.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

namespace {

constexpr double kTurns = 3.0;
constexpr double kSecondsPerTurn = 4.0;  // of the lesson's motor: 90 deg a second

/// Motion of the coupler, which never turns in a parallelogram.
struct Journey {
    int frames = 0;
    int on_branch = 0;
    int said = 0;  ///< frames that were reported as change points

    void add(const State& state) {
        const double turn = 2.0 * state.p[2].tail<3>().norm();
        // 1e-6: at a change point a position is known to the square root of Newton's tolerance, 3e-7
        on_branch += turn < 1e-6 ? 1 : 0;
    }
};

/// Starts each Newton iteration at the last pose, and accepts any pose that it finds.
Journey by_newton_from_last_pose(const Lesson& lesson, State state, int frames_per_turn) {
    const System system(lesson.mechanism, everything(lesson.mechanism));
    NewtonStepper<OmegaLocal> newton(system);
    Journey journey;
    for (int k = 1; k <= kTurns * frames_per_turn; ++k) {
        ++journey.frames;
        newton.start(state, kSecondsPerTurn * k / frames_per_turn);
        if (!solve(newton).converged) { continue; }
        state = newton.state();
        journey.add(state);
    }
    return journey;
}

Journey by_tracker(const Lesson& lesson, const State& state, int frames_per_turn) {
    System system(lesson.mechanism, everything(lesson.mechanism));
    MotionTracker tracker(system, state, 0.0);
    Journey journey;
    for (int k = 1; k <= kTurns * frames_per_turn; ++k) {
        ++journey.frames;
        if (!tracker.advance_to(kSecondsPerTurn * k / frames_per_turn)) { continue; }
        journey.add(tracker.frame().state);
        journey.said += tracker.frame().change_point ? 1 : 0;
    }
    return journey;
}

}  // namespace

Result parallelogram_through_change_points() {
    const Lesson lesson = shipped_lesson("loops/parallelogram.toml");
    const State start = assembled(lesson);
    Result result;
    result.naive =
        "at the change point both branches satisfy all equations, and the nearest pose is on the other "
        "branch about half of the time. The motion continues there without a message.";
    result.ours =
        "every step up to the change point is proved to stay on its branch. Across the change point, the "
        "continued last tangent distinguishes the branches. The frames at the change points are reported as "
        "such.";
    for (const int frames : {8, 40, 360}) {  // 45 deg + k 360 deg / n meets 180 deg and 360 deg exactly
        const Journey naive = by_newton_from_last_pose(lesson, start, frames);
        const Journey ours = by_tracker(lesson, start, frames);
        const double all = kTurns * frames;
        result.measurements.push_back(of_both(
            "frames on the branch, of " + std::to_string(int(all)) + " in three turns",
            double(naive.on_branch), at_most(0.9 * all), double(ours.on_branch), exactly(all)));
        result.measurements.push_back(
            of_ours("frames reported as change points", double(ours.said), exactly(2.0 * kTurns)));
    }
    const Journey beside = by_tracker(lesson, start, 50);  // at least 1.8 deg from the change points
    result.measurements.push_back(of_ours(
        "on the branch, of 150 that step over these points", double(beside.on_branch), exactly(150.0)));
    return result;
}

}  // namespace jw::hard
