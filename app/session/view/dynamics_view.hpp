#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// The equations of motion at one moment as plain values, computed once for panel, text and JSON.
namespace jw {

/// Slide 24 in (r, ω′), body frames at the centres of mass:
///
///   | M   Φqᵀ | |  q̈ |   | Q |
///   | Φq   0  | | −λ | = | γ |,   M = diag(m I, J′),   Q = [f; n′ − ω̃′J′ω′]
///
/// M, Q and q̈ have one entry per column of (r, ω′), bodies in the order of the mechanism, then one θ per
/// screw, which has neither mass nor force.
struct DynamicsView {
    struct Body {
        std::string name;
        double mass = 0.0;                    ///< [kg]
        Mat3 J_local = Mat3::Zero();          ///< about the centre of mass [kg m²]
        Vec3 f = Vec3::Zero();                ///< of Q, global [N]
        Vec3 n_local = Vec3::Zero();          ///< of Q: n′ − ω̃′J′ω′ [N m]
        Vec3 r_ddot = Vec3::Zero();           ///< of the centre of mass [m/s²]
        Vec3 omega_local_dot = Vec3::Zero();  ///< [rad/s²]
    };
    struct Multiplier {
        std::string owner;  ///< joint or driver
        std::string row;    ///< "p1 y"
        double lambda = 0.0;
        bool left_out = false;  ///< its row is redundant: any λ would do, 0 is shown
    };
    std::vector<Body> bodies;
    std::vector<Multiplier> multipliers;  ///< one per row of Φq
    MatrixX M;
    MatrixX jacobian;
    VectorX Q;
    VectorX acceleration;  ///< q̈, solved here again, whatever the lesson's method
    VectorX lambda;
    VectorX gamma;
    double residual = 0.0;  ///< |M q̈ − Φqᵀ λ − Q| / (|M q̈| + |Q|)
    Energy energy;
    Vec3 momentum = Vec3::Zero();          ///< Σ m ṙ [kg m/s]
    Vec3 angular_momentum = Vec3::Zero();  ///< about the global origin, global [kg m²/s]

    /// True if no row is redundant: λ is unique.
    bool unique() const;
};

/// @param state,velocity of the body frames as given
/// @param energy as the run computed it; otherwise it is found from the state
/// @return nothing for mechanisms that are so large that a dense system takes too long
std::optional<DynamicsView> dynamics_view_of(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const std::optional<Energy>& energy = std::nullopt);

/// The equations of motion at a step of a motion by masses and forces; nothing at other steps.
std::optional<DynamicsView> dynamics_view_of(const Step& step);

}  // namespace jw
