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

/// By descending Landen transformations (arithmetic-geometric mean); modulus 0 <= k < 1.
Jacobi jacobi(Real x, Real k);
/// Quarter period K(k).
Real quarter_period(Real k);
/// x in [0, K] with sn x = s, cn x = c (Carlson's R_F).
Real inverse_sn(Real s, Real c, Real k);

/// The trajectory of a scene that elliptic functions solve: the pendulum, the four-bars, the symmetric top,
/// the free body. Nothing for others.
std::optional<Trajectory> closed_form(const Scene& scene);

}  // namespace jw::reference
