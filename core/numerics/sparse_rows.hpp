#pragma once

#include <array>
#include <vector>

#include "core/numerics/linear.hpp"

/// Sparse storage of Φq: every row involves the columns of at most two bodies and one artificial coordinate,
/// so that m rows are m small records for any number of columns.
namespace jw {

/// Row of Φq.
struct SparseRow {
    static constexpr int kMostColumns = 7;  ///< columns of a body: r and p

    std::array<int, 2> first_column{-1, -1};  ///< first column of body i and of body j; -1: none, or fixed
    int theta_column = -1;                    ///< -1: none
    std::array<std::array<double, kMostColumns>, 2> block{};
    double theta = 0.0;

    /// True if two rows have the same columns, whatever their numbers.
    bool same_columns(const SparseRow& other) const {
        return first_column == other.first_column && theta_column == other.theta_column;
    }
};

/// Φq [rows x columns], row by row.
struct SparseRows {
    int columns = 0;  ///< columns of the whole matrix
    int width = 6;    ///< columns of one body: 6 or 7
    std::vector<SparseRow> rows;

    /// Calls `f(column, value)` for every entry of a row, zeros included.
    template <class F>
    void for_each_entry(const SparseRow& row, F&& f) const {
        for (std::size_t side = 0; side < 2; ++side) {
            if (row.first_column[side] < 0) { continue; }
            for (int k = 0; k < width; ++k) {
                f(row.first_column[side] + k, row.block[side][static_cast<std::size_t>(k)]);
            }
        }
        if (row.theta_column >= 0) { f(row.theta_column, row.theta); }
    }

    /// out = Φq x
    void multiply(const VectorX& x, VectorX& out) const;
    /// Φqᵀ λ
    VectorX transposed_times(const VectorX& lambda) const;
    /// Writes Φq to a matrix [rows x columns] that is already allocated.
    void write(MatrixX& matrix) const;
};

}  // namespace jw
