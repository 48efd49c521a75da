#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Symmetric block-sparse matrices with square blocks of one size B, factored as L D Lᵀ without allocation.
/// Smaller blocks are padded with rows of zeros and 1 on the diagonal.
///
/// The structure is computed once: a fill-reducing order and the list of block operations of a factorisation.
namespace jw {

/// Symbolic factorisation: the blocks and the operations on them, without numbers.
class BlockStructure {
public:
    /// Block above the diagonal, in column `node` of the pivot's row; the pivot comes first in the order.
    struct Upper {
        int node = 0;
        int block = 0;  ///< index of the block's storage
    };
    /// Update of an elimination step: S_ij -= X_kiᵀ Y_kj for a pair of blocks of the pivot's row.
    struct Update {
        int target = 0;  ///< storage of S_ij, i before j; a diagonal block where i = j
        int left = 0;    ///< X_ki: index in the pivot's uppers
        int right = 0;   ///< Y_kj
    };
    struct Pivot {
        int node = 0;
        std::vector<Upper> uppers;
        std::vector<Update> updates;
    };

    BlockStructure() = default;
    /// Orders the nodes by minimum degree; of equal ones, the lowest node comes first.
    /// @param neighbours [n]: nodes that share a block with node n, without n itself, each once
    explicit BlockStructure(const std::vector<std::vector<int>>& neighbours);

    int nodes() const { return static_cast<int>(position_.size()); }
    /// Number of stored blocks: the diagonal ones in the order of the nodes, then those above the diagonal.
    int blocks() const { return blocks_; }
    /// Pivots in the order of elimination.
    const std::vector<Pivot>& pivots() const { return pivots_; }
    /// Position of a node in the order of elimination.
    int position(int node) const { return position_[static_cast<std::size_t>(node)]; }
    /// Storage index of block (a, b), a before b in the order.
    int block_of(int a, int b) const;

private:
    std::vector<Pivot> pivots_;
    std::vector<int> position_;
    int blocks_ = 0;
};

namespace kernels {

/// C += A Bt, all B x B or B x K, row-major: C (B x B), A (B x K), Bt (K x B).
template <int B, int K>
inline void add_product(double* c, const double* a, const double* bt) {
    for (int row = 0; row < B; ++row) {
        double sum[B];
        for (int k = 0; k < B; ++k) { sum[k] = c[row * B + k]; }
        for (int m = 0; m < K; ++m) {
            const double factor = a[row * K + m];
            for (int k = 0; k < B; ++k) { sum[k] += factor * bt[m * B + k]; }
        }
        for (int k = 0; k < B; ++k) { c[row * B + k] = sum[k]; }
    }
}

/// C -= Xᵀ Y, all B x B row-major.
template <int B>
inline void subtract_transposed_product(double* c, const double* x, const double* y) {
    for (int row = 0; row < B; ++row) {
        double sum[B];
        for (int k = 0; k < B; ++k) { sum[k] = c[row * B + k]; }
        for (int m = 0; m < B; ++m) {
            const double factor = x[m * B + row];
            for (int k = 0; k < B; ++k) { sum[k] -= factor * y[m * B + k]; }
        }
        for (int k = 0; k < B; ++k) { c[row * B + k] = sum[k]; }
    }
}

}  // namespace kernels

/// Numbers of a matrix with this structure.
template <int B>
class BlockMatrix {
public:
    static constexpr int kBlock = B * B;

    explicit BlockMatrix(const BlockStructure& structure)
        : structure_(&structure),
          values_(static_cast<std::size_t>(structure.blocks()) * kBlock, 0.0),
          inverse_diagonal_(static_cast<std::size_t>(structure.nodes()) * B, 1.0) {
        std::size_t widest = 0;
        for (const auto& pivot : structure.pivots()) { widest = std::max(widest, pivot.uppers.size()); }
        scaled_.resize(widest * kBlock);
    }

    void set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }
    double* block(int index) { return values_.data() + static_cast<std::ptrdiff_t>(index) * kBlock; }
    const double* block(int index) const {
        return values_.data() + static_cast<std::ptrdiff_t>(index) * kBlock;
    }

    /// Factors as L D Lᵀ in place. `on_pivot(node, diagonal)` is called with every diagonal block just before
    /// it is factored and may strike out rows.
    template <class OnPivot>
    void factor(OnPivot&& on_pivot) {
        for (const auto& pivot : structure_->pivots()) {
            double* diagonal = block(pivot.node);
            on_pivot(pivot.node, diagonal);
            double* inverse = &inverse_diagonal_[static_cast<std::size_t>(pivot.node) * B];
            factor_diagonal(diagonal, inverse);
            double* scaled = scaled_.data();
            for (const auto& upper : pivot.uppers) {
                double* x = block(upper.block);
                forward(diagonal, x);
                for (int row = 0; row < B; ++row) {
                    for (int k = 0; k < B; ++k) { scaled[row * B + k] = inverse[row] * x[row * B + k]; }
                }
                scaled += kBlock;
            }
            for (const auto& update : pivot.updates) {
                const double* x = block(pivot.uppers[static_cast<std::size_t>(update.left)].block);
                kernels::subtract_transposed_product<B>(
                    block(update.target), x,
                    scaled_.data() + static_cast<std::ptrdiff_t>(update.right) * kBlock);
            }
        }
    }
    void factor() {
        factor([](int, double*) {});
    }

    /// Solves in place; `b` has B numbers per node.
    void solve(double* b) const {
        for (const auto& pivot : structure_->pivots()) {
            double* z = b + static_cast<std::ptrdiff_t>(pivot.node) * B;
            const double* l = block(pivot.node);
            for (int row = 1; row < B; ++row) {
                for (int m = 0; m < row; ++m) { z[row] -= l[row * B + m] * z[m]; }
            }
            double scaled[B];
            const double* inverse = &inverse_diagonal_[static_cast<std::size_t>(pivot.node) * B];
            for (int row = 0; row < B; ++row) { scaled[row] = inverse[row] * z[row]; }
            for (const auto& upper : pivot.uppers) {
                double* target = b + static_cast<std::ptrdiff_t>(upper.node) * B;
                const double* x = block(upper.block);
                for (int m = 0; m < B; ++m) {
                    for (int k = 0; k < B; ++k) { target[k] -= scaled[m] * x[m * B + k]; }
                }
            }
            for (int row = 0; row < B; ++row) { z[row] = scaled[row]; }
        }
        const auto& pivots = structure_->pivots();
        for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
            double* z = b + static_cast<std::ptrdiff_t>(pivot->node) * B;
            const double* inverse = &inverse_diagonal_[static_cast<std::size_t>(pivot->node) * B];
            double sum[B] = {};
            for (const auto& upper : pivot->uppers) {
                const double* known = b + static_cast<std::ptrdiff_t>(upper.node) * B;
                const double* x = block(upper.block);
                for (int m = 0; m < B; ++m) {
                    for (int k = 0; k < B; ++k) { sum[m] += x[m * B + k] * known[k]; }
                }
            }
            const double* l = block(pivot->node);
            for (int row = B - 1; row >= 0; --row) {
                z[row] -= inverse[row] * sum[row];
                for (int m = row + 1; m < B; ++m) { z[row] -= l[m * B + row] * z[m]; }
            }
        }
    }

    /// 1 / D of one row of a node.
    double inverse_pivot(int node, int row) const {
        return inverse_diagonal_[static_cast<std::size_t>(node) * B + static_cast<std::size_t>(row)];
    }

private:
    /// Writes L below the diagonal of `a`, and 1 / D to `inverse`.
    static void factor_diagonal(double* a, double* inverse) {
        for (int column = 0; column < B; ++column) {
            const double pivot = a[column * B + column];
            inverse[column] = 1.0 / pivot;
            for (int row = column + 1; row < B; ++row) {
                const double factor = a[column * B + row] * inverse[column];
                for (int k = row; k < B; ++k) { a[row * B + k] -= factor * a[column * B + k]; }
            }
            for (int row = column + 1; row < B; ++row) {
                a[row * B + column] = a[column * B + row] * inverse[column];
            }
        }
    }
    /// X = L⁻¹ X
    static void forward(const double* l, double* x) {
        for (int row = 1; row < B; ++row) {
            for (int m = 0; m < row; ++m) {
                const double factor = l[row * B + m];
                for (int k = 0; k < B; ++k) { x[row * B + k] -= factor * x[m * B + k]; }
            }
        }
    }

    const BlockStructure* structure_;
    std::vector<double> values_;
    std::vector<double> inverse_diagonal_;
    std::vector<double> scaled_;  ///< Y_kj = D⁻¹ X_kj of one pivot's row
};

}  // namespace jw
