#pragma once

#include <vector>

#include "core/dynamics/link_equations.hpp"
#include "core/dynamics/loads.hpp"

/// Which forces and torques a joint or driver can carry, whatever form its equations have.
namespace jw {

/// Centroidal scene at one moment, and where the six equations of equilibrium of every moving body stand.
struct Situation {
    Situation(const Centroidal& scene, double t, const State& state);

    const Centroidal* scene;
    double t;       ///< [s]
    double length;  ///< ℓ, the extent of the mechanism: torques are divided by it [m]
    std::vector<BodyKinematics<OmegaGlobal>> bodies;
    std::vector<int> first_of_body;  ///< -1 for a fixed one
    Eigen::Index size = 0;           ///< equations of equilibrium
};

/// Where a link's wrench is said to act.
struct Place {
    Vec3 point = Vec3::Zero();       ///< on body j, global [m]
    Vec3 direction = Vec3::UnitZ();  ///< of its axis, any length
};
Place place_of(const Link& link, const Situation& situation);

/// Columns: wrenches that the link can carry, orthonormal when torques are divided by ℓ.
struct Carrier {
    MatrixX wrench;          ///< on body j at the link's point, global [6 x k]
    MatrixX equilibrium;     ///< the same on all bodies, about their centres of mass [equations x k]
    MatrixX lambda;          ///< the same as λ of the link's rows [rows x k]
    double violation = 0.0;  ///< largest |Φ| of its rows, by its change when bodies move by ℓ
};
Carrier carrier_of(const Link& link, const Vec3& point, const Situation& situation);

}  // namespace jw
