#pragma once

#include <optional>

#include "core/equations/system.hpp"

/// How a velocity violates equations that allow it to first order: order and coefficient, by power series.
namespace jw {

/// Highest order at which a departure is searched for.
inline constexpr int kHighestOrder = 8;

/// First term by which all paths along a velocity violate an equation, if the earlier terms are zero:
/// `coefficient` times a coordinate to the power `order`.
struct Departure {
    int order = 0;             ///< 2 to kHighestOrder
    double coefficient = 0.0;  ///< > 0 [unit of Φ / (unit of the coordinate)^order]
    int joint = -1;            ///< joint whose equation is violated, -1 for a driver
    int driver = -1;
    int body = 0;       ///< body whose coordinate it is
    int direction = 0;  ///< 0, 1, 2: x, y, z of its origin [m]; 3: its turn [rad]
};

/// Expands the path q₀ + q₁ s + q₂ s² + ... along a velocity q₁: J q_k = -R_k, with R_k the coefficient k of
/// Φ(q₀ + ... + q_(k-1) s^(k-1)). Independent equations determine q_k; the others hold or are violated.
///
/// An equation that is violated by c s^k excludes every motion with this velocity if the velocity is the only
/// freedom, if k = 2, or if no other velocity violates an equation at a lower order: then c s^k is the first
/// term of all paths in this direction. In other cases (a cusp: y² = x³) nothing is claimed.
///
/// @param system drivers stand still at time 0
/// @param state satisfies the constraints
/// @param direction columns of (r, ω') and θ
/// @return nothing if, up to kHighestOrder, no equation is violated by more than errors explain: those of
/// rounding, and those of a pose that is known only as well as it satisfies the equations
/// @source Taylor coefficients and left null vectors: the Liapunov-Schmidt reduction
std::optional<Departure> find_departure(const System& system, const State& state, const VectorX& direction);

}  // namespace jw
