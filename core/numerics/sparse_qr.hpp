#pragma once

#include <vector>

#include "core/numerics/sparse_rows.hpp"

/// Orthogonal factors of a large Φq over the graph of its joints: the multifrontal QR of Φqᵀ.
///
/// Rows of Φq form groups: those of a joint, say. Groups that share a body are neighbours; one after the
/// other is eliminated, in a front that holds its own rows and those of the neighbours that are left. What a
/// front cannot eliminate is handed to the front of its next neighbour. Work and memory grow with the sum of
/// the squares of the fronts: linearly with the bodies of chains, ladders and trees of loops.
/// @source Duff and Reid 1983; Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 5
namespace jw {

/// Which rows, columns and fronts there are; knows nothing of numbers.
class SparseQrStructure {
public:
    /// An entry of Φq and its place in a front.
    struct Entry {
        int row = 0;     ///< of Φq
        int side = 0;    ///< 0, 1: block of body i, j; 2: θ
        int column = 0;  ///< of the front
    };
    /// Columns of one body (or one θ) that first appear in this front.
    struct Unknowns {
        int first = 0;  ///< column of Φq
        int count = 0;
        std::vector<Entry> entries;
    };
    struct Front {
        int own = 0;            ///< columns of the front that are eliminated here, the first ones
        std::vector<int> rows;  ///< of Φq, one per column of the front: own ones, then those of later nodes
        std::vector<Unknowns> unknowns;
        std::vector<int> children;
        std::vector<int> to_parent;  ///< for columns from `own` on: the column of the parent's front
        int most_lines = 0;          ///< lines that the front can have
    };

    SparseQrStructure() = default;
    /// @param group_of_row ascending from 0, one per row: groups are eliminated in this order. Empty: rows
    /// that
    ///        touch the same columns form a group, and the order is the one with least work.
    SparseQrStructure(const SparseRows& rows, const std::vector<int>& group_of_row);

    /// False once the rows touch other columns than those that this was made for.
    bool fits(const SparseRows& rows) const;
    const std::vector<Front>& fronts() const { return fronts_; }

private:
    std::vector<SparseRow> columns_of_rows_;  ///< for `fits`
    int columns_ = -1;
    std::vector<Front> fronts_;
};

/// Numbers of one such factorisation, D⁻¹ Φq S of row sizes D and column sizes S. Rows that have less than a
/// threshold beside the rows eliminated before are left out ("repeat others").
///
/// With P the rows that count and R the others, Φqᵀ = Q [R_P R_R; 0 E] where E, what was left of the rows R,
/// is taken for zero: σ_(r+1) ≤ ‖E‖_F and σ_r ≥ 1 / ‖R_P⁻¹‖_F.
class SparseQr {
public:
    /// @param group_of_row as for SparseQrStructure
    explicit SparseQr(std::vector<int> group_of_row = {}) : group_of_row_(std::move(group_of_row)) {}

    /// @param row, column sizes by which rows are divided and columns multiplied
    /// @param threshold rows with less than this part of the largest row left repeat others
    void compute(const SparseRows& rows, const VectorX& row, const VectorX& column, double threshold);

    int rank() const { return static_cast<int>(counted_.size()); }
    double threshold() const { return threshold_; }
    /// Length of the largest row.
    double largest() const { return largest_; }
    /// What was left of every row when its turn came, over the largest row.
    const std::vector<double>& pivots() const { return pivots_; }
    /// Rows that count, in the order of elimination, and those that repeat others.
    const std::vector<int>& counted() const { return counted_; }
    const std::vector<int>& repeating() const { return repeating_; }
    /// ‖E‖_F
    double left_over() const { return left_over_; }

    /// ‖R_P⁻¹‖_F
    double inverse_norm() const;

    /// In place, scaled: c_P becomes z with R_Pᵀ z = c_P; c_R what R_Rᵀ z misses of it.
    void solve_lower(VectorX& c) const;
    /// In place, scaled: v_P becomes -R_P⁻¹ R_R v_R + R_P⁻¹ v_P.
    void solve_upper(VectorX& v) const;
    /// Q and Qᵀ in place; numbers of the rows that count stand where `slot_of` says.
    void multiply_by_q(VectorX& y) const;
    void multiply_by_q_transposed(VectorX& y) const;
    /// Place among the columns in which the number of a row that counts stands.
    int slot_of(int row) const { return slot_of_row_[static_cast<std::size_t>(row)]; }

private:
    struct Reflection {
        int column = 0;
        int line = 0;
        double tau = 0.0;
    };
    struct Numbers {
        int lines = 0;            ///< that the front has
        int counted = 0;          ///< of its own columns
        int handed = 0;           ///< lines that go to the parent, after the counted ones
        bool compressed = false;  ///< those are an upper triangle
        std::size_t values = 0;   ///< where its lines x columns begin, column after column
        std::vector<int> slots;   ///< place among the columns of Φq of every line
        std::vector<int> rows;    ///< of Φq, one per column, own ones as pivoted
        std::vector<Reflection> reflections;
    };

    void prepare(const SparseRows& rows);
    void gather(const SparseRows& rows, const VectorX& row, const VectorX& column, std::size_t f);
    void eliminate(std::size_t f, double least);
    void reflect(std::size_t f, int column, int line, int columns);
    void hand_down(std::size_t f, std::vector<MatrixX>& inverse) const;
    double* column_of(std::size_t f, int column);
    const double* column_of(std::size_t f, int column) const;

    std::vector<int> group_of_row_;
    SparseQrStructure structure_;
    std::vector<Numbers> numbers_;
    std::vector<double> values_;
    std::vector<double> pivots_;
    std::vector<int> counted_;
    std::vector<int> repeating_;
    std::vector<int> slot_of_row_;
    double threshold_ = 0.0;
    double largest_ = 0.0;
    double left_over_ = 0.0;
    mutable std::vector<double> lines_;
};

}  // namespace jw
