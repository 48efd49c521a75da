#include "core/position.hpp"

namespace jw {

namespace {

constexpr int kMostBranches = 4;  // each attempt turns one body; a loop of more is going in circles

}  // namespace

template <class C>
PositionOutcome solve_position(
    const System& given, State& state, double t, const PositionObserver& observer) {
    const std::vector<int> sides = intended_sides(given);
    System system = given;  // rows are chosen anew where the given ones turn out bad at the solution
    NewtonStepper<C> stepper(system);
    PositionOutcome outcome;
    State guess = state;
    int iterations = 0;
    int choices = 0;
    while (true) {
        stepper.start(guess, t);
        while (!stepper.outcome()) {
            const NewtonStep step = stepper.step();
            if (observer) { observer(step, stepper.state()); }
        }
        outcome.newton = *stepper.outcome();
        iterations += outcome.newton.iterations;
        outcome.newton.iterations = iterations;
        if (!outcome.newton.converged) {
            outcome.failure = diagnose(system, state, stepper.state(), t, iterations);
            return outcome;
        }
        const auto wrong = find_wrong_branch(system, stepper.state(), sides);
        const bool complete = left_out_rows_hold(system, stepper.state());
        if (!wrong && complete) {
            state = stepper.state();
            return outcome;
        }
        if (!complete && choices++ < kMostBranches && system.choose_rows(stepper.state())) {
            guess = stepper.state();
            continue;
        }
        if (!wrong) {
            outcome.failure = diagnose(system, state, stepper.state(), t, iterations);
            return outcome;
        }
        if (outcome.branches_left == kMostBranches) {
            outcome.failure = PositionFailure{
                FailureCause::wrong_branch,
                outcome.newton.largest_row,
                wrong->measure,
                outcome.newton.residual,
                0.0,
                iterations,
                wrong,
                t};
            return outcome;
        }
        guess = stepper.state();
        leave_branch(system, *wrong, guess);
        ++outcome.branches_left;
        if (observer) { observer(*wrong, guess); }
    }
}

template PositionOutcome solve_position<TrueEulerParameters>(
    const System&, State&, double, const PositionObserver&);
template PositionOutcome solve_position<ModifiedEulerParameters>(
    const System&, State&, double, const PositionObserver&);
template PositionOutcome solve_position<OmegaLocal>(const System&, State&, double, const PositionObserver&);
template PositionOutcome solve_position<OmegaGlobal>(const System&, State&, double, const PositionObserver&);

}  // namespace jw
