#include <algorithm>
#include <array>
#include <cmath>

#include "app/hard/cases.hpp"
#include "app/hard/variants.hpp"
#include "core/assembler.hpp"
#include "core/position.hpp"

/// Rank and redundancy of loops that move although counting says no: turned, scaled, with long vectors.
namespace jw::hard {

namespace {

struct Loop {
    const char* lesson;
    int rank;  ///< known: one freedom each
};
constexpr std::array kLoops{
    Loop{"loops/bennett.toml", 17}, Loop{"loops/bricard.toml", 29}, Loop{"loops/four-bar.toml", 17},
    Loop{"loops/double-scott-russell.toml", 35}};
constexpr int kTurns = 50;

/// What a rank on paper often is taken of: Φq in (r, p) without the rows pᵀp = 1.
int rank_without_normalisation(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Assembler<ModifiedEulerParameters> assembler(system, false);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    return rank_by_elimination(assembler.jacobian(), kRankThreshold);
}

VectorX pair_singular_values(const Mechanism& mechanism) {
    return verdict_on(with_form(mechanism, ParallelForm::pair)).singular_values;
}

struct Verdicts {
    int right = 0;
    int least_dof = 1000;
    double least_margin = 1e300;

    void add(const Loop& loop, const RankReport& report) {
        right += report.rank == loop.rank ? 1 : 0;
        least_dof = std::min(least_dof, report.dof);
        least_margin = std::min(least_margin, report.largest_gap);
    }
};

/// Newton from 0.05 of the machine and 0.05 rad off, as far as anybody wants to go.
State disturbed(const Mechanism& mechanism, Dice& dice) {
    State state = start_state(mechanism);
    const double size = extent(mechanism);
    for (std::size_t b = 1; b < state.r.size(); ++b) {
        state.r[b] += dice.vector(0.05 * size);
        state.p[b] = turned_local(state.p[b], dice.vector(0.05));
    }
    return state;
}

/// Largest |Φ| where Newton stops as soon as no entry of Φ is above 1e-6, whatever its unit.
double misfit_with_absolute_stop(const System& system, const State& start) {
    NewtonStepper<OmegaLocal> newton(system);
    newton.start(start, 0.0);
    for (int k = 0; k < kMostIterations && !newton.outcome(); ++k) {
        newton.assembler().assemble_phi_and_jacobian(newton.state(), 0.0);
        if (newton.assembler().phi().cwiseAbs().maxCoeff() < 1e-6) { break; }
        newton.step();
    }
    newton.assembler().assemble_phi_and_jacobian(newton.state(), 0.0);
    return newton.assembler().phi().cwiseAbs().maxCoeff();
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
    Verdicts ours;
    int naive_right = 0;
    int least_counted = 1;
    double change = 0.0;
    for (const Loop& loop : kLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = pair_singular_values(mechanism);
        least_counted = std::min(least_counted, mobility_by_counting(mechanism));
        for (int k = 0; k < kTurns; ++k) {
            const Mechanism now = turned(mechanism, dice.turn());
            ours.add(loop, verdict_on(now));
            naive_right += rank_without_normalisation(now) == loop.rank ? 1 : 0;
            change = std::max(change, (pair_singular_values(now) - before).cwiseAbs().maxCoeff() / before(0));
        }
    }
    Result result;
    result.naive =
        "counting says that all four are frames, and (r, p) without the rows pᵀp = 1 shows too many "
        "independent equations: a change of |p| passes for a freedom.";
    result.ours =
        "rank of the (r, ω') matrix: the same verdict in every position, with the redundant equations named.";
    const double all = double(kLoops.size()) * kTurns;
    // (r, p) happens to be right where all axes are parallel and global: not where the scene is turned
    result.measurements.push_back(
        {"right ranks, of 200", Bounded{double(naive_right), at_most(50.0)},
         Bounded{double(ours.right), exactly(all)}});
    result.measurements.push_back(
        {"freedoms found, least of the four", Bounded{double(least_counted), exactly(-9.0)},
         Bounded{double(ours.least_dof), exactly(1.0)}});
    // σ_r is some 0.1; redundant ones are half the position error, which Newton brings below 1e-13
    result.measurements.push_back(
        {"least margin σ_r / σ_r+1", {}, Bounded{ours.least_margin, at_least(1e11)}});
    // n1 pair, since the rule keeps other rows in other positions; 1e-12: a thousand roundings of p
    result.measurements.push_back(
        {"largest change of a singular value, in σ_1", {}, Bounded{change, at_most(1e-12)}});
    return result;
}

Result loops_of_any_size() {
    Verdicts ours;
    int naive_right = 0;
    double naive_misfit = 0.0;
    double misfit = 0.0;
    double change = 0.0;
    for (const Loop& loop : kLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = verdict_on(mechanism).singular_values;
        for (int power = -6; power <= 6; ++power) {
            const double factor = std::pow(10.0, power);
            const Mechanism now = scaled(mechanism, factor);
            const RankReport report = verdict_on(now);
            ours.add(loop, report);
            naive_right += rank_by_elimination(equations_of(now).jacobian, 1e-6) == loop.rank ? 1 : 0;
            if (power % 3 == 0) {
                change =
                    std::max(change, (report.singular_values - before).cwiseAbs().maxCoeff() / before(0));
            }
            Dice dice(2);
            const System system(now, everything(now));
            State state = disturbed(now, dice);
            naive_misfit = std::max(naive_misfit, misfit_with_absolute_stop(system, state) / factor);
            const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
            misfit = std::max(misfit, outcome.ok() ? outcome.newton.residual : 1.0);
        }
    }
    Result result;
    result.naive =
        "what is a length and what is an angle is not told apart: in a machine of a micrometre lengths pass "
        "for zero.";
    result.ours = "lengths are compared in the scene's own unit (µm, mm, m, km ...).";
    result.measurements.push_back(
        {"right ranks, of 52", Bounded{double(naive_right), at_most(48.0)},
         Bounded{double(ours.right), exactly(52.0)}});
    // between two units lengths are up to 32 times the unit or a 32nd of it, which takes 1.5 digits of 11
    // twice
    result.measurements.push_back(
        {"least margin σ_r / σ_r+1", {}, Bounded{ours.least_margin, at_least(1e8)}});
    // the unit goes in steps of 1000; pow and the products round
    result.measurements.push_back(
        {"largest change of σ at 10^±3, 10^±6, in σ_1", {}, Bounded{change, at_most(1e-12)}});
    // Newton's tolerance is 1e-13 of the unit, the largest coordinate is up to 32 units
    result.measurements.push_back(
        {"worst misfit after Newton, in machine sizes", Bounded{naive_misfit, at_least(0.01)},
         Bounded{misfit, at_most(1e-11)}});
    return result;
}

Result long_and_short_vectors() {
    Dice dice(3);
    Verdicts ours;
    int naive_right = 0;
    double change = 0.0;
    int unfinished = 0;
    for (const Loop& loop : kLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = verdict_on(mechanism).singular_values;
        for (int k = 0; k < kTurns; ++k) {
            const Mechanism now = with_vectors_of_any_length(mechanism, dice);
            const RankReport report = verdict_on(now);
            ours.add(loop, report);
            naive_right += rank_by_elimination(equations_of(now).jacobian, 1e-6) == loop.rank ? 1 : 0;
            change = std::max(change, (report.singular_values - before).cwiseAbs().maxCoeff() / before(0));
            const System system(now, everything(now));
            State state = disturbed(now, dice);
            unfinished += solve_position<OmegaLocal>(system, state, 0.0).ok() ? 0 : 1;
        }
    }
    Result result;
    result.naive =
        "an equation of two short vectors is small all over and passes for zero; one of two long vectors is "
        "so large that its rounding passes for an equation.";
    result.ours = "every row is divided by its own size |s_i||s_j|: the numbers are those of unit vectors.";
    const double all = double(kLoops.size()) * kTurns;
    // elimination with full pivoting survives where the lengths happen to be alike
    result.measurements.push_back(
        {"right ranks, of 200", Bounded{double(naive_right), at_most(0.8 * all)},
         Bounded{double(ours.right), exactly(all)}});
    // as without the long vectors, and for the same reason
    result.measurements.push_back(
        {"least margin σ_r / σ_r+1", {}, Bounded{ours.least_margin, at_least(1e11)}});
    // one rounding for each product
    result.measurements.push_back(
        {"largest change of a singular value, in σ_1", {}, Bounded{change, at_most(1e-13)}});
    result.measurements.push_back(
        {"loops not closed from 0.05 rad off", {}, Bounded{double(unfinished), exactly(0.0)}});
    return result;
}

}  // namespace jw::hard
