#include "core/poses/position.hpp"

#include <algorithm>
#include <cmath>

#include "core/poses/closest_fit.hpp"

namespace jw {

namespace {

// two turns: twenty-five steps of half a radian
constexpr double kFarForScrew = 12.0;

/// Moves the nut of the screw with the largest error of advance to its place without rotation: Newton's
/// method, whose steps turn bodies by at most half a radian, would have to screw it there.
/// @return true if the error of a screw is so large that this is worth a try
bool slide_screws(const System& system, State& state) {
    bool any = false;
    for (const Constraint& c : system.constraints()) {
        if (c.role != Role::screw_advance || c.rows() == 0) { continue; }
        const Joint& joint = system.mechanism().joints[static_cast<std::size_t>(c.joint)];
        const JointGeometry& g = joint.geometry;
        const auto i = static_cast<std::size_t>(joint.body_i);
        const auto j = static_cast<std::size_t>(joint.body_j);
        const Vec3 s_i = rotation_matrix(state.p[i]) * g.s_i_local.normalized();
        const Vec3 d = state.r[j] + rotation_matrix(state.p[j]) * g.P_j_local - state.r[i] -
                       rotation_matrix(state.p[i]) * g.P_i_local;
        const double asked = g.d_0 + g.alpha * (state.theta[static_cast<std::size_t>(c.theta)] - g.theta_0);
        const double off = s_i.dot(d) - asked;
        // errors that Newton's method can remove within its iterations need no help
        if (std::abs(off) < kFarForScrew * std::abs(g.alpha)) { continue; }
        const bool moves_j = !system.mechanism().bodies[j].fixed;
        state.r[moves_j ? j : i] += (moves_j ? -off : off) * s_i;
        any = true;
    }
    return any;
}

/// True if the equations hold to the precision of typed numbers.
bool is_met(const System& system, const State& state, double t) {
    ScaledEquations equations(system, t);
    equations.look(state);
    return equations.phi().allFinite() && equations.phi().cwiseAbs().maxCoeff() <= kFloorTolerance;
}

/// True if a formula is far smaller at a solution than where its size was taken: its residual may then be
/// more than rounding there.
bool is_smaller_there(const System& system, const State& state) {
    const auto has_formula = [](const Constraint& c) { return c.role == Role::formula; };
    if (std::ranges::none_of(system.constraints(), has_formula)) { return false; }
    System there = system;
    there.choose_rows(state);
    return !std::ranges::equal(
        there.constraints(), system.constraints(),
        [](const Constraint& a, const Constraint& b) { return a.unit >= 0.1 * b.unit; });
}

constexpr int kMostBranches = 4;  // each attempt turns one body; more attempts would only repeat earlier ones

}  // namespace

template <class C>
PositionOutcome solve_position(
    const System& given, State& state, double t, const PositionObserver& observer) {
    const std::vector<int> sides = intended_sides(given);
    System system = given;  // rows are chosen again if the given ones are bad at the solution
    NewtonStepper<C> stepper(system);
    PositionOutcome outcome;
    State guess = state;
    int iterations = 0;
    int choices = 0;
    bool slid = false;
    bool damped = false;
    bool limited = false;  // whether the last step was limited
    while (true) {
        stepper.start(guess, t);
        while (!stepper.outcome()) {
            const NewtonStep step = stepper.step();
            if (step.rank > 0) { limited = step.fraction < 1.0; }
            if (observer) { observer(step, stepper.state()); }
        }
        outcome.newton = *stepper.outcome();
        iterations += outcome.newton.iterations;
        outcome.newton.iterations = iterations;
        if (!outcome.newton.converged) {
            guess = state;
            if (!slid && slide_screws(system, guess)) {
                slid = true;
                continue;
            }
            // far from any solution, the minimum-norm step turns bodies by many turns and is reduced to
            // almost nothing; damped steps get near. Near singular poses, where full steps oscillate, damped
            // steps converge
            if (!damped) {
                guess = closest_fit(system, state, t);
                damped = true;
                if (limited || is_met(system, guess, t)) { continue; }
            }
            outcome.failure = diagnose(system, state, stepper.state(), t, iterations);
            return outcome;
        }
        const auto wrong = find_wrong_branch(system, stepper.state(), sides);
        const bool complete = left_out_rows_hold(system, stepper.state());
        if (!wrong && complete) {
            state = stepper.state();
            if (!is_smaller_there(system, state)) { return outcome; }
            system.choose_rows(state);
            return solve_position<C>(system, state, t, observer);
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
