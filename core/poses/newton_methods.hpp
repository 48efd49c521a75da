#pragma once

#include <optional>
#include <vector>

#include "core/poses/branches.hpp"
#include "core/poses/newton.hpp"

/// Variants of Newton's method from the same start, for comparison.
namespace jw {

/// Methods that are compared.
enum class NewtonMethod {
    stepwise_limited,     ///< no body turns by more than kLargestTurn in a step: used for all solves
    plain,                ///< whole steps of slide 23 (minimum-norm Δq where rows leave freedoms)
    damped,               ///< steps halved until ‖Φ‖ (scaled) falls
    levenberg_marquardt,  ///< (JᵀJ + λ max diag JᵀJ) Δq = -JᵀΦ, λ lowered where ‖Φ‖ falls
};

/// Iterate and the step taken from there (zero if none).
struct NewtonIterate {
    State state;
    double phi_norm = 0.0;    ///< ‖Φ‖ of all rows, not scaled
    double residual = 0.0;    ///< largest |Φ|, scaled as NewtonStep::residual
    double delta_norm = 0.0;  ///< ‖Δq‖ of the step taken
    double turn = 0.0;        ///< largest turn of a body in the full step [rad]
    double fraction = 1.0;    ///< fraction of the full step that was taken
    double damping = 0.0;     ///< λ of Levenberg-Marquardt, else 0
};

/// Iterates of one method from a start.
struct NewtonTrace {
    NewtonMethod method = NewtonMethod::stepwise_limited;
    std::vector<NewtonIterate> iterates;  ///< iterates, the start first; all their numbers are finite
    bool converged = false;
    std::optional<WrongBranch> wrong_branch;  ///< converged, but to an unintended solution
    /// Measured order of convergence log(ε₃/ε₂) / log(ε₂/ε₁) of the last three decreasing residuals above
    /// rounding: 2 for Newton's method near a regular solution, 1 at a singular one. Absent if there are
    /// fewer than three.
    std::optional<double> order;
};

/// Runs a method for at most kMostIterations steps, or 200 trials of Levenberg-Marquardt. If numbers
/// overflow, the trace ends with the last finite state; it is empty if `start` is not finite.
/// @param normalisation_rows false omits pᵀp - 1 in the (r, p) choices: p then drifts off unit length. There
/// A(p) of the true choice is not a rotation, and that of the modified choice is a scaled rotation; parts can
/// "assemble" deformed. No effect in the ω choices.
template <class C>
NewtonTrace trace_newton(
    const System& system, const State& start, double t, NewtonMethod method, bool normalisation_rows = true);

}  // namespace jw
