#include "core/poses/damped_step.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/eigen/decompositions.hpp"

namespace jw {

namespace {

// the second one changes at most the rounding that the first has left
constexpr int kRefinements = 2;

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Entries of the scaled J.
Triplets scaled_entries(const SparseRows& jacobian, const Scaling& scaling) {
    Triplets entries;
    for (std::size_t k = 0; k < jacobian.rows.size(); ++k) {
        const auto row = static_cast<int>(k);
        jacobian.for_each_entry(jacobian.rows[k], [&](int column, double value) {
            entries.emplace_back(row, column, value / scaling.row(row) * scaling.column(column));
        });
    }
    return entries;
}

/// √(λ m)
double diagonal_of(const Triplets& entries, Eigen::Index columns, double damping) {
    VectorX squares = VectorX::Zero(columns);
    for (const auto& entry : entries) { squares(entry.col()) += entry.value() * entry.value(); }
    return std::sqrt(damping * std::max(1.0, squares.maxCoeff()));
}

VectorX right_side_of(const VectorX& phi, Eigen::Index columns) {
    VectorX right_side = VectorX::Zero(phi.size() + columns);
    right_side.head(phi.size()) = -phi;
    return right_side;
}

}  // namespace

VectorX dense_damped_step(
    const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping) {
    MatrixX J(phi.size(), jacobian.columns);
    jacobian.write(J);
    J = (scaling.row.cwiseInverse().asDiagonal() * J * scaling.column.asDiagonal()).eval();
    const Eigen::Index n = J.cols();
    const double largest = std::max(1.0, J.colwise().squaredNorm().maxCoeff());
    MatrixX stacked(J.rows() + n, n);
    stacked << J, std::sqrt(damping * largest) * MatrixX::Identity(n, n);
    return stacked.householderQr().solve(right_side_of(phi, n)).cwiseProduct(scaling.column);
}

// With s = √(λ m), the minimum satisfies [s I, J; Jᵀ, -s I] [y; Δ] = [-Φ; 0]. Such matrices have an LDLᵀ in
// any order of the unknowns, and their condition is about ‖J‖ / s, which is not squared.
VectorX sparse_damped_step(
    const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping) {
    const Eigen::Index n = jacobian.columns;
    Triplets entries = scaled_entries(jacobian, scaling);
    const double s = diagonal_of(entries, n, damping);
    const auto rows = static_cast<int>(phi.size());
    for (auto& entry : entries) { entry = {rows + entry.col(), entry.row(), entry.value()}; }
    const double a = std::min(s, 1.0);
    for (int k = 0; k < rows; ++k) { entries.emplace_back(k, k, a); }
    for (int k = 0; k < jacobian.columns; ++k) { entries.emplace_back(rows + k, rows + k, -s * (s / a)); }
    Eigen::SparseMatrix<double> lower(rows + n, rows + n);
    lower.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(lower);

    const VectorX right_side = right_side_of(phi, n);
    VectorX solution = factors.solve(right_side);
    // removes the growth of rounding that pivoting in the order of sparsity may cause
    for (int k = 0; k < kRefinements; ++k) {
        const VectorX rest = right_side - lower.selfadjointView<Eigen::Lower>() * solution;
        solution += factors.solve(rest);
    }
    return solution.tail(n).cwiseProduct(scaling.column);
}

VectorX damped_step(const SparseRows& jacobian, const Scaling& scaling, const VectorX& phi, double damping) {
    return jacobian.columns > kMostDenseColumns ? sparse_damped_step(jacobian, scaling, phi, damping)
                                                : dense_damped_step(jacobian, scaling, phi, damping);
}

}  // namespace jw
