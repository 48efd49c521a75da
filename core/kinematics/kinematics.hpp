#pragma once

#include "core/equations/assembler.hpp"
#include "core/poses/least_squares.hpp"

/// Velocity and acceleration analysis: Φq q̇ = ν, Φq q̈ = γ by rank-revealing least squares.
namespace jw {

/// Verdict on a linear system: whether the rows are consistent, and whether the solution is unique.
struct LinearVerdict {
    int rank = 0;
    bool unique = false;     ///< rank = columns; otherwise the solution is the one nearest to the reference
    bool consistent = true;  ///< no row contradicts the others
    double residual = 0.0;   ///< largest |Φq x - b|, scaled, relative to the largest of |b| and 1
    int worst_row = 0;
};

/// Velocity and the verdict on its equations.
struct VelocityOutcome {
    Motion velocity;
    LinearVerdict verdict;
};
/// Acceleration and the verdict on its equations.
struct AccelerationOutcome {
    Motion acceleration;
    LinearVerdict verdict;
};

/// Velocity and acceleration analysis at a state that satisfies the constraints. Reusable; allocates only for
/// its results.
template <class C>
class Kinematics {
public:
    explicit Kinematics(const System& system);

    /// Factors Φq at `state`; call first.
    void set_state(const State& state, double t);
    /// State after one more Newton step: from Newton's tolerance to rounding, where the rows are sound.
    State corrected_state();
    /// Velocities nearest to `reference` (zero: minimum norm) that satisfy Φq q̇ = -Φ_t.
    VelocityOutcome solve_velocity(const Motion& reference);
    /// Minimum-norm accelerations with Φq q̈ = γ at `velocity`.
    AccelerationOutcome solve_acceleration(const Motion& velocity);

    /// Rank by pivots, and the ratio of the last pivot that counts to the previous one: near 0 at a change
    /// point.
    int rank() const { return rank_; }
    double last_pivot_ratio() const;
    /// Largest |Φ| at the state, scaled.
    double residual() const { return residual_; }
    /// Leaves out the weakest equation, where the position is not accurate enough for it.
    void leave_out_weakest();
    /// Residual Φq x - b of a row in the last solution, scaled.
    double miss(int row) const { return miss_(row); }

    Assembler<C>& assembler() { return assembler_; }

private:
    /// Φq x
    VectorX product(const VectorX& x) const;
    LinearVerdict verdict_of(const VectorX& x, const VectorX& b);

    const System* system_;
    Assembler<C> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    State state_;
    double t_ = 0.0;
    int rank_ = 0;
    double residual_ = 0.0;
    double position_error_ = 0.0;  ///< uncertainty of pivots due to the residual
    VectorX right_side_;
    VectorX solution_;
    VectorX miss_;
};

}  // namespace jw
