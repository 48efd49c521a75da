#pragma once

#include <optional>
#include <vector>

#include "core/branches.hpp"
#include "core/newton.hpp"

/// Variants of Newton's method from one and the same start, to be laid side by side.
namespace jw {

enum class NewtonMethod {
    stepwise_limited,     ///< no body turns by more than kLargestTurn in a step: what the program solves with
    plain,                ///< whole steps of slide 23 (the shortest Δq where rows leave freedoms)
    damped,               ///< steps halved until ‖Φ‖ (scaled) falls
    levenberg_marquardt,  ///< (JᵀJ + λ max diag JᵀJ) Δq = -JᵀΦ, λ lowered where ‖Φ‖ falls
};

/// A state on the way and the step that was taken from there (zero where none was).
struct NewtonIterate {
    State state;
    double phi_norm = 0.0;    ///< ‖Φ‖ of all rows, as they are
    double residual = 0.0;    ///< largest |Φ|, scaled as NewtonStep::residual
    double delta_norm = 0.0;  ///< ‖Δq‖ of the step taken
    double turn = 0.0;        ///< largest turn of a body in the full step [rad]
    double fraction = 1.0;    ///< of the full step that was taken
    double damping = 0.0;     ///< λ of Levenberg-Marquardt, else 0
};

struct NewtonTrace {
    NewtonMethod method = NewtonMethod::stepwise_limited;
    std::vector<NewtonIterate> iterates;  ///< the start first; all numbers in it are finite
    bool converged = false;
    std::optional<WrongBranch> wrong_branch;  ///< converged, but to a solution that is not meant
    /// log(ε₃/ε₂) / log(ε₂/ε₁) of the last three residuals that fall and are no rounding: 2 for Newton next
    /// to a regular solution, 1 at a singular one. Absent where there are no three such.
    std::optional<double> order;
};

/// At most kMostIterations steps, or 200 trials of Levenberg-Marquardt. Where numbers run out of bounds the
/// trace ends with the last finite state; it is empty if `start` is not finite.
/// @param normalisation_rows false leaves pᵀp - 1 out in the (r, p) choices: Newton then lets p drift off
///        unit length, where A(p) of the true choice is no rotation and that of the modified one a scaled
///        rotation; parts can "assemble" deformed. No difference in the ω choices.
template <class C>
NewtonTrace trace_newton(
    const System& system, const State& start, double t, NewtonMethod method, bool normalisation_rows = true);

}  // namespace jw
