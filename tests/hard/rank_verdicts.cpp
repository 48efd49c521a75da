#include <algorithm>
#include <cmath>

#include "core/equations/assembler.hpp"
#include "core/model/transformed.hpp"
#include "core/poses/position.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/known_loops.hpp"

/// Rank and redundancy of loops that move although counting says no: turned, and with vectors of any length.
namespace jw::hard {

namespace {

constexpr int kRotations = 50;

/// Rank of Φq in (r, p) without the rows pᵀp = 1, as it is often computed on paper.
int rank_without_normalisation(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Assembler<ModifiedEulerParameters> assembler(system, false);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    return rank_by_elimination(assembler.jacobian(), kRankThreshold);
}

VectorX pair_singular_values(const Mechanism& mechanism) {
    return verdict_on(with_form(mechanism, ParallelForm::pair)).singular_values;
}

/// Every axis and side vector has a length of its own between 1e-6 and 1e6.
Mechanism with_vectors_of_any_length(Mechanism mechanism, Dice& dice) {
    for (Joint& joint : mechanism.joints) {
        JointGeometry& g = joint.geometry;
        for (Vec3* v : {&g.s_i_local, &g.s_j_local, &g.h_i_local, &g.h_j_local}) {
            *v *= std::pow(10.0, dice.number(-6.0, 6.0));
        }
    }
    return mechanism;
}

}  // namespace

Result loops_turned_at_random() {
    Dice dice(1);
    Verdicts verdicts;
    int least_counted = 1;
    double change = 0.0;
    for (const KnownLoop& loop : kKnownLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = pair_singular_values(mechanism);
        least_counted = std::min(least_counted, mobility_by_counting(mechanism));
        for (int k = 0; k < kRotations; ++k) {
            const Mechanism now = moved_rigidly(mechanism, dice.turn());
            verdicts.add(loop, verdict_on(now));
            verdicts.add_naive(loop, rank_without_normalisation(now));
            change = std::max(change, relative_change(pair_singular_values(now), before));
        }
    }
    Result result;
    result.naive =
        "counting says that all four are rigid. In (r, p) without the rows pᵀp = 1, too many equations are "
        "independent, because a change of |p| is taken for a freedom.";
    result.ours = "the verdict is the same in every position, and the redundant equations are named.";
    const double all = double(kKnownLoops.size()) * kRotations;
    // (r, p) happens to be right where all axes are parallel and global: not where the scene is turned
    result.measurements.push_back(of_both(
        "right ranks, of 200", double(verdicts.naive_right), at_most(50.0), double(verdicts.right),
        exactly(all)));
    result.measurements.push_back(of_both(
        "freedoms found, least of the four", double(least_counted), exactly(-9.0), double(verdicts.least_dof),
        exactly(1.0)));
    // σ_r is some 0.1; those of redundant rows are half the position error, which Newton brings below 1e-13
    result.measurements.push_back(of_ours("least margin σ_r / σ_r+1", verdicts.least_margin, at_least(1e11)));
    // n1 pair, since the rule keeps other rows in other positions; 1e-12: a thousand roundings of p
    result.measurements.push_back(
        of_ours("largest change of a singular value, in σ_1", change, at_most(1e-12)));
    return result;
}

Result long_and_short_vectors() {
    Dice dice(3);
    Verdicts verdicts;
    double change = 0.0;
    int unfinished = 0;
    for (const KnownLoop& loop : kKnownLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = verdict_on(mechanism).singular_values;
        for (int k = 0; k < kRotations; ++k) {
            const Mechanism now = with_vectors_of_any_length(mechanism, dice);
            const RankReport report = verdict_on(now);
            verdicts.add(loop, report);
            verdicts.add_naive(loop, rank_by_elimination(equations_of(now).jacobian, 1e-6));
            change = std::max(change, relative_change(report.singular_values, before));
            const System system(now, everything(now));
            State state = disturbed(now, dice);
            unfinished += solve_position<OmegaLocal>(system, state, 0.0).ok() ? 0 : 1;
        }
    }
    Result result;
    result.naive =
        "an equation of two short vectors has only small entries and is taken for zero; one of two long "
        "vectors is so large that its rounding is taken for an equation.";
    result.ours = "the numbers are the same as for unit vectors.";
    const double all = double(kKnownLoops.size()) * kRotations;
    // elimination with full pivoting gives the right rank where the lengths happen to be alike
    result.measurements.push_back(of_both(
        "right ranks, of 200", double(verdicts.naive_right), at_most(0.8 * all), double(verdicts.right),
        exactly(all)));
    // the same bound as without the long vectors, for the same reason
    result.measurements.push_back(of_ours("least margin σ_r / σ_r+1", verdicts.least_margin, at_least(1e11)));
    // one rounding for each product
    result.measurements.push_back(
        of_ours("largest change of a singular value, in σ_1", change, at_most(1e-13)));
    result.measurements.push_back(
        of_ours("loops not closed from 0.05 rad off", double(unfinished), exactly(0.0)));
    return result;
}

}  // namespace jw::hard
