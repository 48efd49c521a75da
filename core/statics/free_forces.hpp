#pragma once

#include "core/equations/assembler.hpp"
#include "core/motion/loads.hpp"
#include "core/poses/least_squares.hpp"

/// Loads along the freedoms of a mechanism at rest, and how they change with its pose.
namespace jw {

/// At a pose that satisfies the constraints: freedoms N with Φq N = 0 and Nᵀ M N = I, loads Q, multipliers λ
/// for which Q + Φqᵀ λ is small.
class FreeForces {
public:
    /// @param system all joints, with drivers at rest; must outlive this, as `scene`
    FreeForces(const Centroidal& scene, const System& system, double t);

    /// Takes a pose of the centroidal frames, and factors its equations; call first.
    void set(const State& state);
    /// Finds freedoms, multipliers and loads at the pose; call before what is below.
    void find_forces();
    /// Counts the turns of rotational springs up to the pose.
    void count_turns();

    const State& state() const { return state_; }
    const Loads& loads() const { return loads_; }
    int rank() const { return rank_; }
    /// Largest movement of a body in columns: turn [rad] or displacement [extents].
    double movement(const VectorX& columns) const;
    /// Q by columns at a pose.
    VectorX force_at(const State& state, const Motion* velocity = nullptr) const;
    /// The part of columns that is free at this pose, in scaled unknowns.
    VectorX free_part(VectorX columns);
    const Layout<OmegaLocal>& layout() const { return assembler_.layout(); }

    int freedoms() const { return static_cast<int>(free_.cols()); }
    const MatrixX& free() const { return free_; }  ///< N [columns of (r, ω') and θ x freedoms]
    const VectorX& push() const { return push_; }  ///< Nᵀ Q: accelerations from rest along the freedoms
    /// Largest |Nᵀ Q| of a freedom, divided by the sizes of all loads times its largest movement.
    double residual() const;
    /// K = -Nᵀ ∂(Q + Φqᵀ λ)/∂q N, from `points` (2 or 4) poses per freedom [1/s²].
    MatrixX stiffness(int points);
    /// C = -Nᵀ ∂Q/∂q̇ N [1/s].
    MatrixX damping() const;
    /// Stiffness of loads that change by their own size along a unit of movement [1/s²].
    double stiffness_size() const;

private:
    void find_freedoms();
    VectorX mass_times(const VectorX& columns) const;
    void measure_loads();

    const System* system_;
    Loads loads_;
    double t_;
    double length_;
    Assembler<OmegaLocal> assembler_;
    Assembler<OmegaLocal> beside_;  ///< at the poses around
    LeastSquares least_squares_;
    Scaling scaling_;
    State state_;
    int rank_ = 0;
    MatrixX free_;
    VectorX lambda_;
    VectorX push_;
    double size_ = 0.0;  ///< of all loads together [N m]: forces times the extent, and torques
};

}  // namespace jw
