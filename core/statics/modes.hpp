#pragma once

#include <complex>
#include <vector>

#include "core/statics/free_forces.hpp"

/// Small motions about an equilibrium: z̈ + C ż + K z = 0 along the freedoms, and whether it is stable.
namespace jw {

/// A small motion δ(t) = Re(e^(st) (shape + i shape_late)).
struct Mode {
    std::complex<double> s;  ///< [1/s]; its imaginary part, 0 or positive, is the angular frequency
    Motion shape;            ///< the largest movement is 1: turns [rad, body frame], or extents [m]
    Motion shape_late;       ///< a quarter of a period later; 0 where everything moves in phase
};

enum class Stability {
    stable,    ///< no small motion grows
    unstable,  ///< one grows, as Mode::s says
    /// A freedom is neither held nor pushed to first order, or the loads can feed a motion that neither grows
    /// nor decays to first order.
    cannot_tell,
};

struct SmallMotions {
    std::vector<Mode> modes;  ///< one that grows first, then slow before fast
    Stability stability = Stability::cannot_tell;
    bool is_conservative = true;  ///< K is symmetric up to rounding: the loads have a potential here
    bool is_damped = false;
};

/// Linearises the equations of motion at an equilibrium. K is the derivative of Q + Φqᵀ λ along the freedoms,
/// with λ fixed, from five poses each (error of order h⁴); it contains the curvature of the constraints.
SmallMotions small_motions(FreeForces& forces);

}  // namespace jw
