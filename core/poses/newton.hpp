#pragma once

#include <concepts>
#include <optional>

#include "core/equations/assembler.hpp"
#include "core/poses/least_squares.hpp"

/// Newton-Raphson method of slide 23: the stepper does one iteration at a time, a solve is a loop over it.
namespace jw {

/// Largest rotation of a body in one iteration [rad]; beyond this, Newton's method is not reliable:
/// minimum-norm steps are erratic from 66.8 deg of misalignment on (docs/notation.md).
inline constexpr double kLargestTurn = 0.5;
inline constexpr int kMostIterations = 60;
/// Residual (scaled) at which a stalled iteration is accepted: the loops of a lesson close only to its typed
/// digits, and seven are enough.
inline constexpr double kFloorTolerance = 1e-7;

/// Rule for the fraction of a step that is taken.
enum class StepRule {
    limited,      ///< no body turns by more than kLargestTurn: used for all solves
    whole,        ///< the whole step
    line_search,  ///< halved until ‖Φ‖ (scaled) falls
};
/// Options of Newton's method.
struct NewtonOptions {
    StepRule rule = StepRule::limited;
    /// False omits pᵀp - 1 in the (r, p) choices; p is then not normalised at the end either.
    bool normalisation_rows = true;
};

/// One iteration: the residual at its start, and the step taken from there.
struct NewtonStep {
    int iteration = 0;           ///< 0 for the start
    double phi_norm = 0.0;       ///< ‖Φ‖ of all rows, not scaled
    double residual = 0.0;       ///< largest |Φ| in the scene's units (System::row_unit)
    int largest_row = 0;         ///< row of the largest residual
    double largest_value = 0.0;  ///< Φ of that row, not scaled
    bool converged = false;      ///< no step was needed: the members below are 0
    double delta_norm = 0.0;     ///< ‖Δq‖ of the step taken
    double turn = 0.0;           ///< largest turn of a body in the full step [rad]
    double fraction = 1.0;  ///< fraction of the full step that was taken; below 1 if the rule shortened it
    int rank = 0;           ///< independent equations used
};

/// Result of a solve.
struct NewtonOutcome {
    bool converged = false;
    bool at_floor = false;  ///< converged to the precision of the lesson's numbers, not of the arithmetic
    int iterations = 0;     ///< steps taken
    double residual = 0.0;  ///< largest |Φ|, scaled
    int largest_row = 0;
    double largest_value = 0.0;
};

/// Residual (scaled) at which Newton's method from `start` has converged: rounding of its largest coordinate.
double residual_tolerance(const System& system, const State& start);

/// Newton's method, one iteration per call. Reusable: `start` begins a new solve without allocating.
template <class C>
class NewtonStepper {
public:
    /// @param system must outlive this; its rows may be chosen again between solves
    explicit NewtonStepper(const System& system, NewtonOptions options = {});

    /// Starts a solve from `state` at time `t` [s].
    void start(State state, double t);
    /// Evaluates the residual and takes one step unless it is small enough. Call while `outcome()` is empty.
    NewtonStep step();

    const std::optional<NewtonOutcome>& outcome() const { return outcome_; }
    const State& state() const { return state_; }
    Assembler<C>& assembler() { return assembler_; }

private:
    NewtonStep look();
    void finish(const NewtonStep& step, bool converged, bool at_floor);
    int solve_for_delta(double residual);
    double limited_fraction() const;
    double searched_fraction();
    double residual_norm_after(double fraction);

    const System* system_;
    NewtonOptions options_;
    Assembler<C> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    State state_;
    double t_ = 0.0;
    int iteration_ = 0;
    double tolerance_ = 0.0;
    double previous_residual_ = 0.0;
    int previous_rank_ = 0;
    bool reached_further_ = false;  ///< the last step used more equations than the previous one
    VectorX right_side_;
    VectorX delta_;
    VectorX linear_residual_;
    VectorX truncated_delta_;
    VectorX trial_delta_;
    State trial_;
    std::optional<NewtonOutcome> outcome_;
};

/// Observer that does nothing, at no cost.
struct Unobserved {
    template <class Event>
    void operator()(const Event& /*event*/) const {}
};

/// Runs a started stepper to its end. Failure to converge is an outcome, not an error.
template <class Stepper, std::invocable<const NewtonStep&> Observer = Unobserved>
NewtonOutcome solve(Stepper& stepper, Observer&& on_step = {}) {
    while (!stepper.outcome()) { on_step(stepper.step()); }
    return *stepper.outcome();
}

/// Most iterations from a good prediction: quadratic convergence needs 4.
inline constexpr int kMostFromPrediction = 8;

/// Applies Newton's method to a prediction near the solution, which is then in `newton`.
/// @return false if it does not converge within kMostFromPrediction iterations
inline bool correct_prediction(NewtonStepper<OmegaLocal>& newton, const State& prediction, double t) {
    newton.start(prediction, t);
    for (int k = 0; k <= kMostFromPrediction && !newton.outcome(); ++k) { newton.step(); }
    return newton.outcome() && newton.outcome()->converged;
}

}  // namespace jw
