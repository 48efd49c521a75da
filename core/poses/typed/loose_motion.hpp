#pragma once

#include <optional>
#include <vector>

#include "core/numerics/svd.hpp"
#include "core/poses/closest_fit.hpp"

/// Motion of joints that are only nearly redundant: as if their smallest singular values were zero, with the
/// equations satisfied in least squares.
namespace jw {

/// All joints of a mechanism, without its drivers.
Selection joints_of(const Mechanism& mechanism);

/// Equations of the joints alone at a state, scaled, with the rows that are chosen there.
struct JointEquations {
    JointEquations(const Mechanism& mechanism, const State& state);
    JointEquations(const JointEquations&) = delete;
    JointEquations& operator=(const JointEquations&) = delete;

    Svd svd() const { return svd_of(scaled.jacobian()); }
    /// Largest |Φ|.
    double misfit() const { return scaled.phi().cwiseAbs().maxCoeff(); }

    System system;
    ScaledEquations scaled;
};

/// Moves a state to where the equations hold best, along the first `rank` singular vectors.
/// @return orthonormal columns that span the free motions, from the last decomposition, which is a few small
/// corrections before the final state; nothing if the state does not settle
std::optional<MatrixX> settle(const Mechanism& mechanism, int rank, State& state);

/// Settled poses along the motions that are free with this rank, from a settled start in both directions.
/// @param step  largest turn of a body [rad], or displacement in sizes of the machine, from pose to pose
/// @param steps at most this many in each direction; fewer where the motion ends
std::vector<State> walk(const Mechanism& mechanism, int rank, const State& start, double step, int steps);

}  // namespace jw
