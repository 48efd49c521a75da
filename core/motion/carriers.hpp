#pragma once

#include <vector>

#include "core/equations/link_equations.hpp"
#include "core/motion/loads.hpp"

/// Forces and torques that a joint or driver can transmit, for any form of its equations.
namespace jw {

/// Centroidal scene at one moment, with the index of the six equilibrium equations of every moving body.
struct Situation {
    Situation(const Centroidal& scene, double t, const State& state);

    const Centroidal* scene;
    double t;       ///< [s]
    double length;  ///< ℓ, the extent of the mechanism: torques are divided by it [m]
    std::vector<BodyKinematics<OmegaGlobal>> bodies;
    std::vector<int> first_of_body;  ///< first equilibrium equation of every body, -1 for a fixed one
    Eigen::Index size = 0;           ///< number of equilibrium equations
};

/// Point and axis that a link's wrench refers to.
struct Place {
    Vec3 point = Vec3::Zero();       ///< point on body j, global [m]
    Vec3 direction = Vec3::UnitZ();  ///< direction of the axis, any length
};
Place place_of(const Link& link, const Situation& situation);

/// Wrenches that a link can transmit, one per column, orthonormal when torques are divided by ℓ.
struct Carrier {
    MatrixX wrench;          ///< on body j at the link's point, global [6 x k]
    MatrixX equilibrium;     ///< the same on all bodies, about their centres of mass [equations x k]
    MatrixX lambda;          ///< the same as multipliers of the link's rows [rows x k]
    double violation = 0.0;  ///< largest |Φ| of its rows, divided by its change when bodies move by ℓ
};
Carrier carrier_of(const Link& link, const Vec3& point, const Situation& situation);

}  // namespace jw
