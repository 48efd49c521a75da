#pragma once

#include <concepts>
#include <optional>

#include "core/assembler.hpp"
#include "core/least_squares.hpp"

/// Newton-Raphson of slide 23, one iteration at a time: the stepper is the algorithm, a solve is a loop over
/// it.
namespace jw {

/// A turn of more than this in one iteration leaves the region where Newton can be trusted: minimum-norm
/// steps are erratic from 66.8 deg of misalignment on (docs/notation.md) [rad].
inline constexpr double kLargestTurn = 0.5;
inline constexpr int kMostIterations = 60;
/// A lesson's own numbers may close to no better than their typed digits: seven of them are enough to go on.
inline constexpr double kFloorTolerance = 1e-7;

/// How much of a step is taken.
enum class StepRule {
    limited,      ///< no body turns by more than kLargestTurn: what the program solves with
    whole,        ///< all of it, wherever that leads
    line_search,  ///< halved until ‖Φ‖ (scaled) falls
};
struct NewtonOptions {
    StepRule rule = StepRule::limited;
    /// False leaves pᵀp - 1 out in the (r, p) choices; p is then not made unit in the end either.
    bool normalisation_rows = true;
};

/// One iteration: the residual at its start, and the step that was taken from there.
struct NewtonStep {
    int iteration = 0;           ///< 0 for the first look
    double phi_norm = 0.0;       ///< ‖Φ‖ of all rows, as they are
    double residual = 0.0;       ///< largest |Φ| in the scene's units (System::row_unit)
    int largest_row = 0;         ///< where it is
    double largest_value = 0.0;  ///< Φ of that row, as it is
    bool converged = false;      ///< no step was needed: the members below are 0
    double delta_norm = 0.0;     ///< ‖Δq‖ of the step taken
    double turn = 0.0;           ///< largest turn of a body in the full step [rad]
    double fraction = 1.0;       ///< of the full step that was taken; below 1 where the rule shortened it
    int rank = 0;                ///< independent equations used
};

struct NewtonOutcome {
    bool converged = false;
    bool at_floor = false;  ///< converged to the accuracy of the lesson's own numbers, not of the arithmetic
    int iterations = 0;     ///< steps taken
    double residual = 0.0;  ///< largest |Φ|, scaled
    int largest_row = 0;
    double largest_value = 0.0;
};

/// Residual (scaled) at which Newton from `start` has converged: rounding of its largest coordinate.
double residual_tolerance(const System& system, const State& start);

/// Reusable: `start` begins a new solve without allocating.
template <class C>
class NewtonStepper {
public:
    /// `system` must outlive this; its rows may be chosen anew between solves.
    explicit NewtonStepper(const System& system, NewtonOptions options = {});

    void start(State state, double t);
    /// Looks at the residual and takes one step unless it is small enough. Call while `outcome()` is empty.
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
    bool reached_further_ = false;  ///< the last step used more equations than the one before
    VectorX right_side_;
    VectorX delta_;
    VectorX linear_residual_;
    VectorX truncated_delta_;
    VectorX trial_delta_;
    State trial_;
    std::optional<NewtonOutcome> outcome_;
};

/// Watches nothing and costs nothing.
struct Unobserved {
    template <class Event>
    void operator()(const Event& /*event*/) const {}
};

/// Runs a started stepper to its end. Not converging is an outcome, not an error.
template <class Stepper, std::invocable<const NewtonStep&> Observer = Unobserved>
NewtonOutcome solve(Stepper& stepper, Observer&& on_step = {}) {
    while (!stepper.outcome()) { on_step(stepper.step()); }
    return *stepper.outcome();
}

}  // namespace jw
