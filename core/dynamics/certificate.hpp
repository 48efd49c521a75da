#pragma once

#include <random>
#include <span>
#include <vector>

#include "core/body_kinematics.hpp"
#include "core/dynamics/forces.hpp"
#include "core/dynamics/link_equations.hpp"
#include "core/dynamics/motion_equations.hpp"

/// Proof of accelerations: put back into the equations of motion as slide 24 writes them, in the coordinates
/// of the bodies, with all joints of the mechanism.
namespace jw {

/// Coordinate choice of bodies whose accelerations are known: the bias of an arm or a point holds them, so
/// that rate and bias of a jet are Φ̇ and Φ̈ themselves. Has no Jacobian.
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
    // set where somebody asks for e0 ... e3
    Vec4 p_dot = Vec4::Zero();
    Vec4 p_bias = Vec4::Zero();  ///< p̈
};

/// Checks accelerations by the equations that they must satisfy:
///
///   M q̈ - Q = Φqᵀ λ for some λ,   Φq q̈ = γ
///
/// The first holds if δᵀ (M q̈ - Q) = 0 for every δ with Φq δ = 0. One δ is drawn at random at each state: a
/// residual that is orthogonal to it has probability 0. Where δ comes from does not matter, since Φq δ = 0 is
/// checked here too: Φq (q̈ + δ) = γ says both in one pass over the joints.
///
/// Uses the jets of the primitives and the pose, velocity and acceleration of every body; no tree of joints,
/// no factorisation, no choice of rows. Cost linear in the bodies; nothing is allocated.
/// @source slides 18-19 and 24
class Certificate {
public:
    /// @param scene must outlive this
    /// @param shares into which the joints are parted: `check` looks at one of them, at the next one in the
    ///        next call. Forces are looked at in each.
    Certificate(const Centroidal& scene, const Baumgarte& baumgarte, int shares = 1);

    /// Random numbers of which `equations` are to make δ, one per velocity of theirs, between -1 and 1.
    std::span<const double> draw(int count);
    /// @param bodies one per moving body, with δ
    AccelerationResidual check(double t, std::span<const ProbedBody> bodies);
    /// Of y with ẏ as `equations` evaluated it. @param in_bodies says δ where `equations` cannot
    AccelerationResidual check(
        MotionEquations& equations, MotionEquations& in_bodies, double t, const std::vector<double>& y,
        const std::vector<double>& y_dot);

private:
    void find_loaded();
    void measure_units();
    void set_bodies(std::span<const ProbedBody> bodies);
    void set_forces(double t, std::span<const ProbedBody> bodies);
    double force_residual(std::span<const ProbedBody> bodies) const;
    /// Calls `f(link, equation, k, jet, f_dot, f_ddot)` for every row of this share of the links.
    template <class F>
    void for_each_row(double t, F&& f) const;
    double drift(double t) const;

    const Centroidal* scene_;
    Baumgarte baumgarte_;
    std::size_t shares_;
    std::size_t share_ = 0;
    double extent_;
    bool needs_p_ = false;  ///< a driver asks for one of e0 ... e3
    std::vector<int> moving_;
    std::vector<int> loaded_moving_;  ///< of those, the ones whose pose loads ask for
    std::vector<Link> links_;
    std::vector<std::size_t> first_row_;  ///< of every link in inverse_unit_
    std::vector<double> inverse_unit_;    ///< per row: 1 / change of Φ when bodies move by one extent
    std::vector<BodyKinematics<KnownAccelerations>> bodies_;
    std::vector<BodyKinematics<OmegaLocal>> loaded_;  ///< as forces want them
    std::vector<double> acceleration_;                ///< per body: size of what Φ̈ adds up [1/s²]
    std::vector<double> speed_;                       ///< per body [1/s]
    double largest_ = 0.0;                            ///< of acceleration_
    double fastest_ = 0.0;                            ///< of speed_
    std::vector<BodyForce> forces_;
    std::minstd_rand random_;
    std::vector<double> drawn_;
    std::vector<ProbedBody> probed_;
    std::vector<double> flat_;
};

}  // namespace jw
