#pragma once

#include <optional>

#include "tests/reference/scene.hpp"

namespace jw::reference {

/// Jacobi's elliptic functions.
struct Jacobi {
    Real sn = 0.0L;
    Real cn = 1.0L;
    Real dn = 1.0L;
};

/// k² + k'² = 1; both are given, for near a separatrix k' has digits that k has lost.
struct Modulus {
    Real k = 0.0L;
    Real k_prime = 1.0L;
};

/// Jacobi's elliptic functions by descending Landen transformations (arithmetic-geometric mean).
Jacobi jacobi(Real x, const Modulus& modulus);
/// Quarter period K.
Real quarter_period(const Modulus& modulus);
/// x in [0, K] with sn x = s, cn x = c (Carlson's R_F).
Real inverse_sn(Real s, Real c, const Modulus& modulus);

/// The trajectory of a scene that elliptic functions solve: the pendulum, the four-bars, the symmetric top,
/// the free body. Nothing for others.
std::optional<Trajectory> closed_form(const Scene& scene);

}  // namespace jw::reference
