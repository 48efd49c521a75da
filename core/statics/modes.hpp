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
    std::vector<Mode> modes;  ///< growing ones first, then from slow to fast
    Stability stability = Stability::cannot_tell;
    /// The pose has more freedoms than those beside it; then there are no modes.
    bool is_singular = false;
    /// The law of a load has a kink at the pose; then there are no modes either.
    bool at_kink = false;
    bool is_conservative = true;  ///< K is symmetric up to rounding: the loads have a potential here
    bool is_damped = false;
};

/// Linearises the equations of motion at an equilibrium. K is the derivative of Q + Φqᵀ λ along the freedoms,
/// with λ fixed, by differences of fourth order; it contains the curvature of the constraints. It is computed
/// twice: along the eigenvectors of the first K, stiff freedoms do not hide soft ones.
SmallMotions small_motions(FreeForces& forces);

/// Bound on the error of each eigenvalue of the symmetric part of K: differences of the loads and reactions
/// on the bodies that move, and rounding of the largest one.
/// @param shapes columns of the freedoms, one per eigenvalue
VectorX stiffness_errors(const FreeForces& forces, const MatrixX& shapes, double largest);

}  // namespace jw
