#include <array>
#include <cstdio>

#include "core/kinematics/motion_tracker.hpp"
#include "core/numerics/linear.hpp"
#include "tests/bench/clock.hpp"
#include "tests/support/driven_loops.hpp"

/// `folding`: what a turn of a crank costs that comes within e of folding, each step proved: links 1 - e, 2,
/// 1 on a ground of 2, samples 12 and 100 a turn. Steps (proofs that held), tries (proofs in all) and time
/// per turn, time as a multiple of that for e = 0.1, largest error against the closed form; "ends" where
/// rounding hides the branch.
namespace {

using namespace jw;

struct Turn {
    int steps = 0;
    int tries = 0;
    double error = 0.0;
    double ended = 0.0;  ///< time at which the motion ended, 0 if it did not [s]
};

Turn turn(const test::DrivenLoop& loop, int samples) {
    System system(loop.mechanism, everything(loop.mechanism));
    MotionTracker tracker(system, start_state(loop.mechanism), 0.0);
    Turn out;
    for (int k = 1; k <= samples; ++k) {
        const double t = static_cast<double>(k) / samples;
        const bool reached = tracker.advance_to(t);
        const MotionFrame& frame = tracker.frame();
        out.steps += frame.substeps;
        out.tries += frame.tries;
        if (!reached) {
            out.ended = frame.t;
            return out;
        }
        const Vec3 point =
            frame.state.r[at(loop.body)] + rotation_matrix(frame.state.p[at(loop.body)]) * loop.point_local;
        out.error = std::max(out.error, (point - loop.expected(t)).norm());
    }
    return out;
}

}  // namespace

int main() {
    std::printf("a crank within e of folding, each step proved\n");
    std::printf(
        "%8s %8s %6s %6s %10s %6s %9s\n", "e", "samples", "steps", "tries", "us/turn", "ratio", "error");
    for (const int samples : {12, 100}) {
        double first = 0.0;
        for (int decade = 1; decade <= 14; ++decade) {
            const double e = std::pow(10.0, -decade);
            const test::DrivenLoop loop = test::crank_near_folding(e);
            const Turn found = turn(loop, samples);
            const double time = least_time([&] { turn(loop, samples); });
            if (decade == 1) { first = time; }
            std::printf(
                "%8.0e %8d %6d %6d %10.0f %6.2f ", e, samples, found.steps, found.tries, time, time / first);
            if (found.ended > 0.0) {
                std::printf("ends at %.6f s\n", found.ended);
            } else {
                std::printf("%9.1e\n", found.error);
            }
        }
    }
}
