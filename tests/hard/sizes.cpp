#include <algorithm>
#include <cmath>

#include "core/model/transformed.hpp"
#include "core/poses/position.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/known_loops.hpp"

/// Rank, and closing, of very large and very small machines.
namespace jw::hard {

namespace {

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

/// A mechanism and a copy that is `factor` times as large, on one ground, whose frame is the global one.
Mechanism beside_a_small_one(const Mechanism& large, double factor) {
    Mechanism both = large;
    const Mechanism small = scaled(large, factor);
    const int shift = static_cast<int>(large.bodies.size()) - 1;
    both.bodies.insert(both.bodies.end(), small.bodies.begin() + 1, small.bodies.end());
    for (Joint joint : small.joints) {
        for (int* body : {&joint.body_i, &joint.body_j}) { *body += *body > 0 ? shift : 0; }
        both.joints.push_back(joint);
    }
    return both;
}

/// State with both mechanisms disturbed by the same fraction of their sizes.
State disturbed_side_by_side(const Mechanism& large, const Mechanism& both, double factor, Dice& dice) {
    const State big = disturbed(large, dice);
    State state = start_state(both);
    const std::size_t shift = big.r.size() - 1;
    for (std::size_t b = 1; b < big.r.size(); ++b) {
        state.r[b] = big.r[b];
        state.p[b] = state.p[b + shift] = big.p[b];
        state.r[b + shift] = factor * big.r[b];
    }
    return state;
}

}  // namespace

Result loops_of_any_size() {
    Verdicts verdicts;
    double naive_misfit = 0.0;
    double misfit = 0.0;
    double change = 0.0;
    for (const KnownLoop& loop : kKnownLoops) {
        const Mechanism mechanism = assembled_mechanism(loop.lesson);
        const VectorX before = verdict_on(mechanism).singular_values;
        for (int power = -6; power <= 6; ++power) {
            const double factor = std::pow(10.0, power);
            const Mechanism now = scaled(mechanism, factor);
            const RankReport report = verdict_on(now);
            verdicts.add(loop, report);
            verdicts.add_naive(loop, rank_by_elimination(equations_of(now).jacobian, 1e-6));
            if (power % 3 == 0) {
                change = std::max(change, relative_change(report.singular_values, before));
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
        "lengths and angles are not distinguished. In a machine of one micrometre, lengths are taken for "
        "zero.";
    result.ours = "lengths are compared in the scene's own unit (µm, mm, m, km ...).";
    result.measurements.push_back(of_both(
        "right ranks, of 52", double(verdicts.naive_right), at_most(48.0), double(verdicts.right),
        exactly(52.0)));
    // lengths are between a 32nd of the unit and 32 times the unit, which costs 1.5 of 11 digits twice
    result.measurements.push_back(of_ours("least margin σ_r / σ_r+1", verdicts.least_margin, at_least(1e8)));
    // the unit goes in steps of 1000; pow and the products round
    result.measurements.push_back(
        of_ours("largest change of σ at 10^±3, 10^±6, in σ_1", change, at_most(1e-12)));
    // Newton's tolerance is 1e-13 of the unit; the largest coordinate is up to 32 units
    result.measurements.push_back(of_both(
        "worst misfit after Newton, in machine sizes", naive_misfit, at_least(0.01), misfit, at_most(1e-11)));
    return result;
}

Result large_and_small_side_by_side() {
    constexpr double kFactor = 1e-6;
    Verdicts verdicts;
    int closed = 0;
    double residual = 0.0;
    Dice dice(9);
    for (const KnownLoop& loop : kKnownLoops) {
        const Mechanism large = assembled_mechanism(loop.lesson);
        const Mechanism both = beside_a_small_one(large, kFactor);
        const KnownLoop two{loop.lesson, 2 * loop.rank};
        verdicts.add(two, verdict_on(both));
        verdicts.add_naive(two, rank_by_elimination(equations_of(both).jacobian, 1e-6));
        const System system(both, everything(both));
        State state = disturbed_side_by_side(large, both, kFactor, dice);
        const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
        closed += outcome.ok() ? 1 : 0;
        residual = std::max(residual, outcome.newton.residual);
    }
    Result result;
    result.naive = "a millionth of a length is taken for zero.";
    result.ours =
        "the verdict is right down to about 10^-8 of the size of the machine; a smaller loop counts as a "
        "point. Newton's method solves the small equations after the large ones.";
    result.measurements.push_back(of_both(
        "right ranks, of 4", double(verdicts.naive_right), at_most(1.0), double(verdicts.right),
        exactly(4.0)));
    // σ_r is 1e-7 here, the threshold 1e-9
    result.measurements.push_back(of_ours("least margin σ_r / σ_r+1", verdicts.least_margin, at_least(1e6)));
    result.measurements.push_back(of_ours("closed from 0.05 rad off, of 4", double(closed), exactly(4.0)));
    // Newton's tolerance; a millionth of it would be the small loop's own, which is left to its last step
    result.measurements.push_back(
        of_ours("largest misfit then, in the unit of the large one", residual, at_most(1e-12)));
    return result;
}

}  // namespace jw::hard
