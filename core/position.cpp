#include "core/position.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "core/rank.hpp"

namespace jw {

namespace {

constexpr int kMostBranches = 4;     // each attempt turns one body; a loop of more is going in circles
constexpr int kFitIterations = 200;  // damped steps are linear at worst; enough for three digits of the fit
constexpr double kFlatGradient = 1e-5;       // of |Φq||Φ|: the residual can be lowered no further
constexpr double kLostSingularValue = 1e-6;  // of the largest, at the closest fit

struct Fit {
    VectorX phi;  // scaled
    VectorX raw;
    double flatness = 0.0;
    double smallest_singular_value = 0.0;
};

/// Levenberg-Marquardt to the closest fit: where plain Newton wanders, this tells whether the parts can meet.
Fit closest_fit(const System& system, State state, double t) {
    Assembler<OmegaLocal> assembler(system);
    const Scaling scaling = scaling_of<OmegaLocal>(system);
    const auto scaled_phi = [&](const State& at) {
        assembler.assemble_phi_and_jacobian(at, t);
        return VectorX(assembler.phi().cwiseQuotient(scaling.row));
    };
    const auto scaled_jacobian = [&] {
        return MatrixX(
            scaling.row.cwiseInverse().asDiagonal() * assembler.jacobian() * scaling.column.asDiagonal());
    };

    VectorX phi = scaled_phi(state);
    MatrixX J = scaled_jacobian();
    double damping = 1e-3;
    for (int k = 0; k < kFitIterations; ++k) {
        MatrixX normal = J.transpose() * J;
        normal.diagonal().array() += damping * std::max(1.0, normal.diagonal().maxCoeff());
        VectorX delta = normal.ldlt().solve(-J.transpose() * phi).cwiseProduct(scaling.column);
        const double turn = assembler.layout().largest_turn(delta);
        if (turn > kLargestTurn) { delta *= kLargestTurn / turn; }
        State trial = state;
        assembler.layout().advance(trial, delta);
        const VectorX trial_phi = scaled_phi(trial);
        if (trial_phi.allFinite() && trial_phi.norm() < phi.norm()) {
            state = trial;
            phi = trial_phi;
            damping = std::max(0.3 * damping, 1e-12);
        } else {
            damping *= 4.0;
            assembler.assemble_phi_and_jacobian(state, t);
            if (damping > 1e12) { break; }
        }
        J = scaled_jacobian();
    }
    Fit fit;
    assembler.assemble_phi_and_jacobian(state, t);
    fit.raw = assembler.phi();
    fit.phi = phi;
    const VectorX sigma = singular_values_of(J);
    fit.flatness = (J.transpose() * phi).norm() / std::max(sigma(0) * phi.norm(), 1e-300);
    // smallest among those that should not vanish: redundancy aside, the last ratio that is no rounding
    for (const double s : sigma) {
        if (s > 1e-12 * sigma(0)) { fit.smallest_singular_value = s / sigma(0); }
    }
    return fit;
}

PositionFailure diagnose(const System& system, const State& start, double t, const NewtonOutcome& newton) {
    const Fit fit = closest_fit(system, start, t);
    PositionFailure failure;
    Eigen::Index row = 0;
    failure.residual = fit.phi.cwiseAbs().maxCoeff(&row);
    failure.row = static_cast<int>(row);
    failure.value = fit.raw(row);
    failure.smallest_singular_value = fit.smallest_singular_value;
    failure.iterations = newton.iterations;
    if (failure.residual > 1e-6 && fit.flatness < kFlatGradient) {
        failure.cause = FailureCause::cannot_close;
    } else if (fit.smallest_singular_value < kLostSingularValue) {
        failure.cause = FailureCause::singular;
    }
    return failure;
}

}  // namespace

template <class C>
PositionOutcome solve_position(
    const System& system, State& state, double t, const PositionObserver& observer) {
    const std::vector<int> sides = intended_sides(system);
    NewtonStepper<C> stepper(system);
    PositionOutcome outcome;
    State guess = state;
    int iterations = 0;
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
            outcome.failure = diagnose(system, state, t, outcome.newton);
            return outcome;
        }
        const auto wrong = find_wrong_branch(system, stepper.state(), sides);
        if (!wrong) {
            state = stepper.state();
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
                wrong};
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
