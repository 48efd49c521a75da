#pragma once

#include <vector>

#include "core/equations/system.hpp"
#include "core/numerics/sparse_rows.hpp"

/// Assembly of a system at a state: Φ, Φq and, on demand, the right sides of velocity and acceleration
/// equations.
namespace jw {

/// Conversion between the columns of a coordinate choice and the bodies.
template <class C>
class Layout {
public:
    explicit Layout(const System& system) : system_(&system) {}

    int columns() const { return system_->columns(C::kAngular); }

    /// Velocities as columns: ṙ and ṗ (ω', ω), θ̇.
    VectorX columns_of(const State& state, const Motion& motion) const;
    /// Velocities ṙ, ω', θ̇ from columns.
    Motion motion_of(const State& state, const VectorX& columns) const;
    /// Accelerations r̈, ω̇', θ̈ from columns (p̈ and ω̇ converted as on slide 13).
    Motion acceleration_of(const State& state, const VectorX& columns) const;
    /// Adds Δq to a state: p + Δp (not normalised here), or p rotated by Δq; fixed bodies are unchanged.
    void advance(State& state, const VectorX& delta) const;
    /// Largest rotation of a body by `delta` [rad].
    double largest_turn(const VectorX& delta) const;

private:
    const System* system_;
};

/// Assembles into memory that is allocated once. Rows: joints, drivers, then pᵀp - 1 per moving body in the
/// (r, p) choices unless omitted. Columns: 7 or 6 per moving body, then the artificial coordinates. Φq is
/// stored sparse, a few entries per row; `jacobian()` converts it to a dense matrix.
template <class C>
class Assembler {
public:
    /// @param system must outlive the assembler; its rows may be chosen again between assemblies
    explicit Assembler(const System& system, bool normalisation_rows = true);

    const Layout<C>& layout() const { return layout_; }
    const System& system() const { return *system_; }

    /// Assembles Φ and Φq at `state` and time `t` [s].
    void assemble_phi_and_jacobian(const State& state, double t);
    /// Assembles ν = -Φ_t of the velocity equations Φq q̇ = ν.
    void assemble_nu(double t);
    /// Assembles γ of the acceleration equations Φq q̈ = γ at velocities `motion`.
    void assemble_gamma(const State& state, const Motion& motion, double t);

    const VectorX& phi() const { return phi_; }
    /// Φq in sparse storage.
    const SparseRows& sparse_jacobian() const { return sparse_; }
    /// Φq as a dense matrix [rows x columns]; the first call allocates it.
    const MatrixX& jacobian() const;
    const VectorX& nu() const { return nu_; }
    const VectorX& gamma() const { return gamma_; }

private:
    template <Content K>
    void set_bodies(const State& state, const Motion* motion);
    SparseRow& row_at(int row) { return sparse_.rows[static_cast<std::size_t>(row)]; }
    template <class J>
    void write_rows(const J& jet, int body_i, int body_j, int theta, unsigned left_out, int first_row);

    const System* system_;
    Layout<C> layout_;
    bool normalisation_rows_;
    std::vector<BodyKinematics<C>> bodies_;
    VectorX phi_;
    SparseRows sparse_;
    mutable MatrixX jacobian_;
    mutable bool jacobian_is_old_ = true;
    VectorX nu_;
    VectorX gamma_;
};

/// Φ of all equations of a constraint at `state`, including those without a row.
VectorX values_of(const Constraint& constraint, const State& state);

/// All equations of a constraint, including those without a row, with their derivatives in the coordinates C.
struct ConstraintTerms {
    VectorX value;        ///< Φ
    VectorX rate;         ///< its time derivative
    VectorX bias;         ///< part of the second derivative that is quadratic in velocities: -γ
    MatrixX block_i;      ///< 7 or 6 columns of body i in Φq, 0 where Φ does not depend on them
    MatrixX block_j;      ///< columns of body j
    VectorX block_theta;  ///< column of the artificial coordinate
};
template <class C>
ConstraintTerms terms_of(const Constraint& constraint, const State& state, const Motion& motion);

/// Value, rate and acceleration of a measure between two bodies (θ for a screw) at given motion.
struct Measured {
    double value = 0.0;
    double rate = 0.0;
    double acceleration = 0.0;
};
Measured evaluate_measure(
    const Measure& measure, int body_i, int body_j, int theta, const State& state, const Motion& velocity,
    const Motion& acceleration);

}  // namespace jw
