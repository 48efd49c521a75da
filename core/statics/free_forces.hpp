#pragma once

#include "core/equations/assembler.hpp"
#include "core/motion/loads.hpp"
#include "core/poses/least_squares.hpp"

/// Loads along the freedoms of a mechanism at rest, and how they change with its pose.
namespace jw {

/// At a pose that satisfies the constraints: freedoms N with Φq N = 0 and Nᵀ M N = I, loads Q, multipliers λ
/// for which Q + Φqᵀ λ is small. Dry friction is left out: at rest it has no force.
class FreeForces {
public:
    /// @param system all joints, with drivers at rest; must outlive this, as `scene`
    FreeForces(const Centroidal& scene, const System& system, double t);

    /// Takes a pose of the centroidal frames, factors its equations and finds multipliers; call first.
    void set(const State& state);
    /// Finds freedoms and sizes of loads at the pose; call before the functions below.
    void find_forces();
    /// Counts the turns of rotational springs up to the pose.
    void count_turns();

    const State& state() const { return state_; }
    const Loads& loads() const { return loads_; }
    int rank() const { return rank_; }
    /// Largest movement of a body in columns: turn [rad] or displacement [extents].
    double movement(const VectorX& columns) const;
    /// Q + Φqᵀ λ by columns: Q along the freedoms, without the loads of heavy bodies that the joints carry.
    const VectorX& unbalanced() const { return unbalanced_; }
    /// The part of columns that is free at this pose, in scaled unknowns.
    VectorX free_part(VectorX columns);
    const Layout<OmegaLocal>& layout() const { return assembler_.layout(); }

    int freedoms() const { return static_cast<int>(free_.cols()); }
    const MatrixX& free() const { return free_; }  ///< N [columns of (r, ω') and θ x freedoms]
    const VectorX& push() const { return push_; }  ///< Nᵀ Q: accelerations from rest along the freedoms
    /// Largest force or torque that is left over on a body, divided by the sizes of all loads and reactions
    /// on that body.
    double residual() const;
    /// Chooses other freedoms: N becomes N V. @param V orthogonal
    void turn(const MatrixX& V);
    /// K = -Nᵀ ∂(Q + Φqᵀ λ)/∂q N, from four poses per freedom [1/s²].
    MatrixX stiffness();
    /// C = -Nᵀ ∂Q/∂q̇ N [1/s].
    MatrixX damping();
    /// False if the law of a load has a kink at the pose: then K and C are those of one side.
    bool has_smooth_laws() const { return has_smooth_laws_; }
    /// True if a law depends on a rate: unlike a damper, it can feed a motion.
    bool has_laws_of_rates() const;
    /// Work of all loads and reactions, without their signs, along columns: the scale for rounding of Nᵀ Q.
    double work_of_sizes(const VectorX& columns) const;
    /// Stiffness along columns of loads and reactions that change by their own size along a unit of movement:
    /// the scale for rounding of K.
    double stiffness_of_sizes(const VectorX& columns) const;

private:
    void find_freedoms();
    /// Calls `f` with linearised laws: differences then depend only on their slopes at the pose.
    template <class F>
    MatrixX with_linear_laws(F&& f);
    MatrixX stiffness_by_differences();
    MatrixX damping_by_differences() const;
    /// Q by columns at a pose.
    VectorX force_at(const State& state, const Motion* velocity = nullptr) const;
    VectorX mass_times(const VectorX& columns) const;
    void measure_loads();
    /// Movement of a body in columns, as in `movement`.
    double movement_of(int body, const VectorX& columns) const;
    double step_along(const VectorX& columns) const;
    bool moves_theta_alone();

    const System* system_;
    Loads loads_;
    bool has_smooth_laws_ = true;
    double t_;
    double length_;
    Assembler<OmegaLocal> assembler_;
    Assembler<OmegaLocal> beside_;  ///< at poses nearby
    Scaling scaling_;
    LeastSquares least_squares_;
    State state_;
    int rank_ = 0;
    MatrixX free_;
    VectorX lambda_;
    VectorX unbalanced_;
    VectorX push_;
    /// Sizes of all loads and reactions on each body [N m]: forces times the extent, and torques.
    std::vector<double> sizes_;
};

}  // namespace jw
