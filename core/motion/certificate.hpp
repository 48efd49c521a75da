#pragma once

#include <random>
#include <span>
#include <vector>

#include "core/equations/link_equations.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/motion_equations.hpp"

/// Proof of accelerations: they are substituted into the equations of motion of slide 24, in the coordinates
/// of the bodies, with all joints of the mechanism.
namespace jw {

/// Coordinate choice for bodies with known accelerations: the bias of an arm or a point includes them, so
/// that rate and bias of a jet are Φ̇ and Φ̈. It has no Jacobian.
struct KnownAccelerations {
    static constexpr int kAngular = 3;
};

template <>
struct BodyKinematics<KnownAccelerations> {
    Vec3 r = Vec3::Zero();
    Vec4 p = Vec4::Unit(0);
    Mat3 A = Mat3::Identity();
    Vec3 r_dot = Vec3::Zero();
    Vec3 omega = Vec3::Zero();
    Vec3 r_ddot = Vec3::Zero();
    Vec3 alpha = Vec3::Zero();  ///< ω̇
    // set only where a driver prescribes one of e0 ... e3
    Vec4 p_dot = Vec4::Zero();
    Vec4 p_bias = Vec4::Zero();  ///< p̈
};

/// Checks accelerations against the equations that they must satisfy:
///
///   M q̈ - Q = Φqᵀ λ for some λ,   Φq q̈ = γ
///
/// The first holds if δᵀ (M q̈ - Q) = 0 for every δ with Φq δ = 0. One δ is drawn at random at each state: a
/// residual that is orthogonal to it has probability 0. How δ was made does not matter, since Φq δ = 0 is
/// checked here too: Φq (q̈ + δ) = γ verifies both in one pass over the joints.
///
/// Uses the jets of the primitives and pose, velocity and acceleration of every body; no joint tree, no
/// factorisation, no choice of rows. The cost is linear in the bodies; nothing is allocated.
/// @source slides 18-19 and 24
class Certificate {
public:
    /// @param scene must outlive this
    /// @param shares number of parts into which the joints are divided: each call of `check` checks the next
    ///        part. Forces are checked in every call.
    Certificate(const Centroidal& scene, const Baumgarte& baumgarte, int shares = 1);

    /// Draws the random numbers from which the equations make δ: one per velocity, between -1 and 1.
    std::span<const double> draw(int count);
    /// Checks the accelerations of the bodies at time t [s].
    /// @param bodies one per moving body, with δ
    AccelerationResidual check(double t, std::span<const ProbedBody> bodies);
    /// Checks ẏ at y as `equations` evaluated it.
    /// @param in_bodies provides δ where `equations` cannot
    AccelerationResidual check(
        MotionEquations& equations, MotionEquations& in_bodies, double t, const std::vector<double>& y,
        const std::vector<double>& y_dot);

private:
    void find_loaded();
    void measure_units();
    void set_bodies(std::span<const ProbedBody> bodies);
    void set_forces(double t, std::span<const ProbedBody> bodies);
    double force_residual(std::span<const ProbedBody> bodies) const;
    /// Calls `f(link, equation, 1 / unit, Φ, Φ̇, Φ̈, |f̈|)` for every row of this share of the links, f being
    /// the function of a driver.
    template <class F>
    void for_each_row(double t, F&& f) const;
    double drift(double t) const;

    const Centroidal* scene_;
    Baumgarte baumgarte_;
    std::size_t shares_;
    std::size_t share_ = 0;
    double extent_;
    bool needs_p_ = false;  ///< whether a driver prescribes one of e0 ... e3
    std::vector<int> moving_;
    std::vector<int> loaded_moving_;  ///< indices in `moving_` of bodies whose pose the loads need
    std::vector<Link> links_;
    std::vector<std::size_t> first_row_;  ///< index of the first row of every link in inverse_unit_
    std::vector<double> inverse_unit_;    ///< per row: 1 / change of Φ when bodies move by one extent
    std::vector<BodyKinematics<KnownAccelerations>> bodies_;
    std::vector<BodyKinematics<OmegaLocal>> loaded_;  ///< kinematics for add_forces
    std::vector<double> acceleration_;                ///< per body: size of the terms of Φ̈ [1/s²]
    std::vector<double> speed_;                       ///< per body: size of its velocity [1/s]
    double largest_ = 0.0;                            ///< largest of acceleration_
    double fastest_ = 0.0;                            ///< largest of speed_
    std::vector<BodyForce> forces_;
    std::minstd_rand random_;
    std::vector<double> drawn_;
    std::vector<ProbedBody> probed_;
    std::vector<double> flat_;
};

}  // namespace jw
