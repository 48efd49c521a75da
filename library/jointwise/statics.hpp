#pragma once

#include <complex>

#include "jointwise/analysis.hpp"

/// Equilibria of a mechanism under its loads, and small motions about them (docs/statics.md).
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// A small motion about an equilibrium: Re(e^(st) (shape + i shape_late)) is added to the pose, turns in the
/// frames of the bodies. Its largest movement is 1.
struct SmallMotion {
    std::complex<double> s;  ///< [1/s]; its imaginary part, 0 or positive, is the angular frequency
    Rates shape;             ///< [m, rad]
    Rates shape_late;        ///< a quarter of a period later; 0 where all bodies move in phase
};

enum class Stability {
    stable,     ///< no small motion grows
    unstable,   ///< one grows
    not_known,  ///< to first order, one neither grows nor decays; or the pose is singular
};

/// Kind of equilibrium that is looked for.
enum class Seek {
    where_it_rests,  ///< the one to which the loads push the mechanism from the start; not unstable
    nearest,         ///< the one to which Newton's method leads from the start, stable or not
};

struct Equilibrium {
    Moment moment;  ///< at rest at t = 0, with the potential energy; `reactions_at` takes it
    Stability stability = Stability::not_known;
    std::vector<SmallMotion> small_motions;  ///< growing ones first, then from slow to fast
    int freedoms = 0;
    int steps = 0;
    /// Largest force or torque that is left over on a body, relative to the loads and reactions on it.
    double residual = 0.0;
};

/// Equilibrium of the assembled mechanism under its loads; drivers keep their values at t = 0. Every moving
/// body needs a mass. Dry friction is left out.
/// @throws NotReached if the mechanism cannot be assembled, or no equilibrium is found
Equilibrium find_equilibrium(const Mechanism& mechanism, Seek seek = Seek::where_it_rests);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
