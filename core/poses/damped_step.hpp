#pragma once

#include "core/poses/least_squares.hpp"

namespace jw {

/// Step of Levenberg-Marquardt from a state: Δ that minimises ‖J Δ + Φ‖² + λ m ‖Δ‖², with J and Φ scaled and
/// m the largest squared norm of a column of J, at least 1. JᵀJ is not formed, because it would square the
/// condition: up to kMostDenseColumns columns, QR solves [J; √(λ m) I] Δ = [−Φ; 0]; for more columns, sparse
/// factors of the symmetric system of Δ and the remaining Φ are used.
/// @param phi  scaled
/// @return Δ in unknowns that are not scaled
VectorX damped_step(const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping);

// the two ways, for tests
VectorX dense_damped_step(
    const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping);
VectorX sparse_damped_step(
    const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping);

}  // namespace jw
