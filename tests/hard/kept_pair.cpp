#include <algorithm>
#include <cmath>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/rank.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

/// Least rank and worst condition of all rows on the way.
struct Worst {
    int rank = 1000;
    double condition = 0.0;
    double turn = 0.0;  ///< of the turntable where the condition is worst [deg]
};

void look_at(const System& system, const State& state, double t, Worst& worst) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, t);
    const RankReport report = analyse_rank(system, assembler.jacobian(), assembler.phi());
    worst.rank = std::min(worst.rank, report.rank);
    const VectorX& sigma = report.singular_values;
    const double condition = sigma(0) / std::max(sigma(sigma.size() - 1), 1e-16 * sigma(0));
    if (condition > worst.condition) {
        worst.condition = condition;
        worst.turn = 60.0 * t;
    }
}

}  // namespace

/// Measures both at the same poses: those that the rule finds.
Result kept_pair_at_right_angle() {
    const Lesson lesson = shipped_lesson("parallel/which-two-of-three.toml");
    System by_rule(lesson.mechanism, everything(lesson.mechanism));
    Mechanism kept = lesson.mechanism;
    kept.joints.back().parallel_form = ParallelForm::drop_z;
    const System kept_pair(kept, everything(kept));
    MotionTracker tracker(by_rule, assembled(lesson), 0.0, false);
    Worst naive;
    Worst ours;
    int poses = 0;
    for (int k = 0; k <= 240; ++k) {
        const double t = k / 40.0;
        if (!tracker.advance_to(t)) { break; }
        ++poses;
        look_at(by_rule, tracker.frame().state, t, ours);
        look_at(kept_pair, tracker.frame().state, t, naive);
    }
    Result result;
    result.naive =
        "the rows x and y, chosen at the start, become dependent where s_i has turned into the plane x-y. "
        "The Jacobian is singular there, although the mechanism is not.";
    result.ours = "another pair is chosen in time, and the condition numbers stay near those of the start.";
    result.measurements.push_back(of_ours("poses of one turn found, of 241", double(poses), exactly(241)));
    // 12 equations, 12 unknowns
    result.measurements.push_back(of_both(
        "least rank of the 12 rows in one turn", double(naive.rank), at_most(11), double(ours.rank),
        exactly(12)));
    // 2.17 is the condition of the worst pair that the rule keeps; the whole matrix also contains lengths
    result.measurements.push_back(
        of_both("worst condition number", naive.condition, at_least(1e12), ours.condition, at_most(20.0)));
    result.measurements.push_back(
        of_both("turn at which it is worst [deg]", naive.turn, any(), ours.turn, any()));
    return result;
}

}  // namespace jw::hard
