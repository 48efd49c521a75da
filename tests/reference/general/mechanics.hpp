#pragma once

#include <vector>

#include "tests/reference/general/measures.hpp"
#include "tests/reference/ode.hpp"

/// Equations of motion of a model in absolute coordinates: centre of mass c, Euler parameters p, ċ and the
/// global ω of every moving body, then the time.
///
/// With M = S Sᵀ and z = Sᵀ (v̇, ω̇), Gauss's principle of least constraint is least squares: z is nearest to
/// Sᵀ M⁻¹ Q among those with (Φq S⁻ᵀ) z = γ. It is solved by a rank-revealing QR of (Φq S⁻ᵀ)ᵀ, which does not
/// square its condition; λ is never formed.
/// @source Udwadia & Kalaba, A new perspective on constrained motion, Proc. R. Soc. A 439 (1992)
namespace jw::reference::general {

/// Linear equations of all constraints at a state, and which of them are independent.
struct Rows {
    MatX rows;              ///< Φq S⁻ᵀ, each scaled to length 1
    VecX scale;             ///< length before
    std::vector<int> kept;  ///< independent ones, in the order of their pivots
    Real condition = 1.0L;  ///< of the kept ones: largest over smallest pivot
    Real gap = 0.0L;        ///< largest pivot that was not kept
};

struct Accelerations {
    std::vector<Vec3> v_dot;           ///< of the centres of mass, one per body [m/s²]
    std::vector<Vec3> omega_dot;       ///< global
    std::vector<Vec3> free_v_dot;      ///< without constraints: errors are relative to it
    std::vector<Vec3> free_omega_dot;  ///< global
    /// Largest residual of a row that was not kept, divided by its length: how much the rows contradict.
    Real contradiction = 0.0L;
    Real condition = 1.0L;
    int rank = 0;
};

class Mechanics : public Ode {
public:
    explicit Mechanics(const Model& model);

    VecX start() const override;
    void begin_step(const VecX& y) override;
    void derivative(const VecX& y, VecX& y_dot) override;
    void project(VecX& y) override;
    Sample sample(const VecX& y) override;

    /// State with the positions and velocities as given.
    VecX state_of(const PlacedBodies& bodies, Real t) const;
    const PlacedBodies& bodies_at(const VecX& y);
    Rows rows_at(const VecX& y);
    int rank_at(const VecX& y);
    Accelerations accelerations_at(const VecX& y);
    /// Projects only velocities, in the metric of M. @return largest residual left, by the row's length
    Real project_velocities(VecX& y);
    /// Largest |Φ| and |Φ̇|, each divided by the length of its row.
    std::pair<Real, Real> violation_at(const VecX& y);
    /// [J]
    Real kinetic_energy(const VecX& y);
    /// Momentum of all moving bodies, and angular momentum about the origin.
    std::pair<Vec3, Vec3> momentum(const VecX& y);

    const Model& model() const { return model_; }
    int unknowns() const { return 6 * static_cast<int>(moving_.size()); }

private:
    struct Loaded {
        Vec3 force = Vec3::Zero();
        Vec3 torque = Vec3::Zero();  ///< about the centre of mass, global
    };

    void set_state(const VecX& y);
    void find_rows(const std::vector<int>& which);
    std::vector<Loaded> loads() const;
    void push(std::vector<Loaded>& loads, const Fixed& point, const Vec3& force) const;
    VecX free_accelerations() const;
    /// Shortest z with rows z = image.
    VecX least(const VecX& image) const;
    void displace(VecX& y, const VecX& z) const;
    void accelerate(VecX& y, const VecX& z) const;
    VecX values(const std::vector<int>& which, Real Taylor::*part) const;
    VecX velocities() const;

    Model model_;
    std::vector<int> moving_;
    std::vector<int> place_;  ///< index of a body among the moving ones, or -1
    std::vector<Mat3> cholesky_;
    std::vector<int> all_;
    std::vector<int> kept_;
    std::vector<Real> twists_;  ///< of turning springs, from the last begin_step
    PlacedBodies bodies_;
    Real t_ = 0.0L;
    MatX rows_;
    VecX scale_;
};

}  // namespace jw::reference::general
