#pragma once

#include "core/equations/system.hpp"

/// Residuals of position, velocity and acceleration in the equations, independent of how they were found.
namespace jw {

/// Residual of a solution in its equations, and the bound of the residual by rounding.
struct EquationResidual {
    double residual = 0.0;  ///< largest residual of a row, divided by its size (System::row_unit)
    double bound = 0.0;     ///< bound of `residual`
    /// True if rounding explains the residual.
    bool holds() const { return residual <= bound; }
};

/// Residuals of position, velocity and acceleration.
struct KinematicResiduals {
    EquationResidual position;      ///< |Φ|
    EquationResidual velocity;      ///< |Φq q̇ − ν|, per second
    EquationResidual acceleration;  ///< |Φq q̈ − γ|, per second squared
};

/// Computes rates and biases of the equations by the product rule along the motion, in (r, ω). No Jacobian is
/// formed, although velocities and accelerations were computed with one. Linear in the number of bodies.
///
/// Bounds. Position: where Newton's method stops. Velocity and acceleration: a solution x of Φq x = b has a
/// residual from rounding of the terms, at most ε c (|x| + |b| + 1), and from the error of the position, 10
/// |Φ| (|x| + |b| + 1), where rows are redundant. c = 1e4 allows for the block equations of DrivenFrames,
/// which square a condition of at most 100; the term 1 is for drivers at rest, whose rates are rounding of
/// their angles. Where equations contradict each other, or the weakest was left out at a change point, the
/// residual is larger.
KinematicResiduals residuals_of(
    const System& system, const State& state, const Motion& velocity, const Motion& acceleration, double t);

}  // namespace jw
