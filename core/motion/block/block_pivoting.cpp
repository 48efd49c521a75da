#include <limits>

#include <Eigen/SparseLU>

#include "core/motion/block/block_equations.hpp"

/// Accelerations where light bodies carry heavy ones. Φq M⁻¹ Φqᵀ adds 1 / m of both bodies of a joint, and
/// the 1 / m of the heavy one is lost in the rounding of the other. The whole matrix of slide 24 keeps both,
/// and pivoting decides: a light body follows its constraints, a heavy one its forces.
namespace jw {

namespace {

/// Ratio of the pivot by mass to that by geometry below which too many digits are lost. Shipped lessons stay
/// above it; the governor with its thin rods has the smallest, 1e-5.
constexpr double kDigitsAreLost = 1e-6;

}  // namespace

template <int B>
void BlockEquations<B>::compare_masses(double t) {
    if (forgets_masses_) {
        masses_apart_ = true;
        return;
    }
    const double by_geometry = smallest_pivot();
    masses_apart_ = false;
    evaluate_links(Content::jacobian, t);
    factor_in_metric();
    masses_apart_ = smallest_pivot() < kDigitsAreLost * by_geometry;
}

/// | M   Φqᵀ | |  x |   | Q |
/// | Φq   0  | | -λ | = | γ |   with 1 in the diagonal of rows that are not kept. `six_` holds M⁻¹ Q before,
/// x after.
template <int B>
void BlockEquations<B>::solve_by_pivoting() {
    const auto columns = static_cast<Eigen::Index>(6 * moving_.size());
    const auto size = columns + static_cast<Eigen::Index>(nodes_.size()) * B;
    std::vector<Eigen::Triplet<double>> entries;
    VectorX right = VectorX::Zero(size);
    const auto add = [&](Eigen::Index row, Eigen::Index column, double value) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    };
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto first = static_cast<Eigen::Index>(6 * m);
        for (Eigen::Index k = 0; k < 3; ++k) {
            add(first + k, first + k, moving_[m].mass);
            for (Eigen::Index c = 0; c < 3; ++c) { add(first + 3 + k, first + 3 + c, moving_[m].J(k, c)); }
        }
        right.segment<3>(first) = moving_[m].mass * vec3(&six_[6 * m]);
        right.segment<3>(first + 3) = moving_[m].J * vec3(&six_[6 * m + 3]);
    }
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        for (int row = 0; row < B; ++row) {
            if (!has(nodes_[n].kept, row)) { continue; }
            const auto equation = columns + static_cast<Eigen::Index>(n) * B + row;
            for (int k = 0; k < 6; ++k) {
                const auto column = static_cast<Eigen::Index>(6 * moving) + k;
                const double entry = j_[side_at(side) + at(k * B + row)];
                add(equation, column, entry);
                add(column, equation, entry);
            }
        }
    });
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const auto equation = columns + static_cast<Eigen::Index>(n) * B + row;
            const bool kept = has(nodes_[n].kept, row);
            if (!kept) { add(equation, equation, 1.0); }
            right(equation) = kept ? gamma_[n * B + at(row)] : 0.0;
        }
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
    VectorX x = VectorX::Constant(size, std::numeric_limits<double>::quiet_NaN());
    if (lu.info() == Eigen::Success) {
        x = lu.solve(right);
        // iterative refinement: after the first pass the residual of a light body's rows is small only
        // relative to the heavy ones'
        x += lu.solve(right - matrix * x);
    }
    std::copy_n(x.data(), columns, six_.data());
}

template <int B>
double BlockEquations<B>::pivot_of(std::size_t node, int row) const {
    const double inverse = row_size_[node * B + at(row)] * matrix_.inverse_pivot(static_cast<int>(node), row);
    // a pivot that rounding made negative counts as 0
    return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

template <int B>
void BlockEquations<B>::keep_pivots() {
    kept_pivots_.clear();
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) { kept_pivots_.push_back(pivot_of(n, row)); }
    }
}

template <int B>
double BlockEquations<B>::share_of_pivots() const {
    double least = 1.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const double before = kept_pivots_[n * B + at(row)];
            least = std::min(least, before > 0.0 ? pivot_of(n, row) / before : 0.0);
        }
    }
    return least;
}

template void BlockEquations<3>::compare_masses(double);
template void BlockEquations<5>::compare_masses(double);
template void BlockEquations<6>::compare_masses(double);
template void BlockEquations<3>::solve_by_pivoting();
template void BlockEquations<5>::solve_by_pivoting();
template void BlockEquations<6>::solve_by_pivoting();
template void BlockEquations<3>::keep_pivots();
template double BlockEquations<3>::share_of_pivots() const;
template void BlockEquations<5>::keep_pivots();
template double BlockEquations<5>::share_of_pivots() const;
template void BlockEquations<6>::keep_pivots();
template double BlockEquations<6>::share_of_pivots() const;

}  // namespace jw
