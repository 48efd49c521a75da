#pragma once

#include "core/system.hpp"

/// Position, velocity and acceleration put into the equations again, by another way than they were found.
namespace jw {

/// How far an answer misses its equations, and by how much rounding lets it.
struct EquationResidual {
    double residual = 0.0;  ///< largest of a row, divided by its size (System::row_unit)
    double bound = 0.0;     ///< of `residual`
    bool holds() const { return residual <= bound; }
};

struct KinematicResiduals {
    EquationResidual position;      ///< |Φ|
    EquationResidual velocity;      ///< |Φq q̇ − ν|, per second
    EquationResidual acceleration;  ///< |Φq q̈ − γ|, per second squared
};

/// Rates and biases of the equations by the product rule along the motion, in (r, ω): no Jacobian is formed,
/// while velocities and accelerations were solved for with one. Linear in the number of bodies.
///
/// The bounds. Position: where Newton's method stops. Velocity and acceleration: a solution x of Φq x = b
/// misses by rounding of the terms, at most ε c (|x| + |b| + 1), and by what the position is off, 10 |Φ| (|x|
/// + |b| + 1), where rows repeat each other. c = 1e4 allows the block equations of DrivenFrames, which take
/// the square of a condition of at most 100; 1 is for drivers at rest, whose rates are rounding of their
/// angles. Where equations contradict each other or the weakest was left out at a change point, more is left.
KinematicResiduals residuals_of(
    const System& system, const State& state, const Motion& velocity, const Motion& acceleration, double t);

}  // namespace jw
