#pragma once

#include <vector>

#include "core/numerics/sparse_rows.hpp"

/// Multifrontal QR of Φqᵀ over the graph of joints, for large Φq.
///
/// Rows of Φq form groups, for example those of a joint. Groups that share a body are neighbours. They are
/// eliminated one after the other, each in a front that holds its own rows and those of its remaining
/// neighbours. The part that a front cannot eliminate is passed to the front of its next neighbour. Work and
/// memory grow with the sum of the squares of the fronts: linearly with the bodies of chains, ladders and
/// trees of loops.
/// @source Duff and Reid 1983; Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 5
namespace jw {

/// Symbolic factorisation: rows, columns and fronts, without numbers.
class SparseQrStructure {
public:
    /// Entry of Φq and its position in a front.
    struct Entry {
        int row = 0;     ///< row of Φq
        int side = 0;    ///< 0, 1: block of body i, j; 2: θ
        int column = 0;  ///< column of the front
    };
    /// Columns of one body (or one θ) that first appear in this front.
    struct Unknowns {
        int first = 0;  ///< column of Φq
        int count = 0;
        std::vector<Entry> entries;
    };
    struct Front {
        int own = 0;            ///< number of columns of the front that are eliminated here, the first ones
        std::vector<int> rows;  ///< one per column of the front: own rows of Φq, then later ones
        std::vector<Unknowns> unknowns;
        std::vector<int> children;
        std::vector<int> to_parent;  ///< for columns from `own` on: the column of the parent's front
        int most_lines = 0;          ///< largest number of lines of the front
    };

    SparseQrStructure() = default;
    /// @param group_of_row ascending from 0, one per row: groups are eliminated in this order. If empty, rows
    ///        with the same columns form a group, and the order is by minimum degree
    SparseQrStructure(const SparseRows& rows, const std::vector<int>& group_of_row);

    /// True if the rows have the columns for which this structure was made.
    bool fits(const SparseRows& rows) const;
    const std::vector<Front>& fronts() const { return fronts_; }

private:
    std::vector<SparseRow> columns_of_rows_;  ///< for `fits`
    int columns_ = -1;
    std::vector<Front> fronts_;
};

/// Numerical factorisation of D⁻¹ Φq S with row sizes D and column sizes S. Rows are left out as redundant if
/// their remainder after removal of earlier rows is below a threshold.
///
/// With P the independent rows and R the others, Φqᵀ = Q [R_P R_R; 0 E], where E, the remainder of the rows
/// R, is neglected: σ_(r+1) ≤ ‖E‖_F and σ_r ≥ 1 / ‖R_P⁻¹‖_F.
class SparseQr {
public:
    /// @param group_of_row as for SparseQrStructure
    explicit SparseQr(std::vector<int> group_of_row = {}) : group_of_row_(std::move(group_of_row)) {}

    /// Factors D⁻¹ Φq S.
    /// @param row, column sizes D by which rows are divided and S by which columns are multiplied
    /// @param threshold rows whose remainder is below this share of the largest row are redundant
    void compute(const SparseRows& rows, const VectorX& row, const VectorX& column, double threshold);

    int rank() const { return static_cast<int>(counted_.size()); }
    double threshold() const { return threshold_; }
    /// Norm of the largest row.
    double largest() const { return largest_; }
    /// Remainder of every row when it was eliminated, divided by the largest row.
    const std::vector<double>& pivots() const { return pivots_; }
    /// Independent rows, in the order of elimination, and redundant ones.
    const std::vector<int>& counted() const { return counted_; }
    const std::vector<int>& repeating() const { return repeating_; }
    /// ‖E‖_F
    double left_over() const { return left_over_; }

    /// ‖R_P⁻¹‖_F
    double inverse_norm() const;

    /// Solves in place, scaled: c_P becomes z with R_Pᵀ z = c_P, and c_R becomes c_R - R_Rᵀ z.
    void solve_lower(VectorX& c) const;
    /// Solves in place, scaled: v_P becomes R_P⁻¹ (v_P - R_R v_R).
    void solve_upper(VectorX& v) const;
    /// Multiplies by Q or Qᵀ in place; the number that belongs to an independent row is at `slot_of(row)`.
    void multiply_by_q(VectorX& y) const;
    void multiply_by_q_transposed(VectorX& y) const;
    /// Index, among the columns, of the number that belongs to an independent row.
    int slot_of(int row) const { return slot_of_row_[static_cast<std::size_t>(row)]; }

private:
    struct Reflection {
        int column = 0;
        int line = 0;
        double tau = 0.0;
    };
    struct Numbers {
        int lines = 0;            ///< lines in the front
        int counted = 0;          ///< pivots among its own columns
        int handed = 0;           ///< lines passed to the parent, after the counted ones
        bool compressed = false;  ///< true if the passed lines are an upper triangle
        std::size_t values = 0;   ///< offset of its lines x columns, column by column
        std::vector<int> slots;   ///< index among the columns of Φq of every line
        std::vector<int> rows;    ///< rows of Φq, one per column, own ones as pivoted
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
