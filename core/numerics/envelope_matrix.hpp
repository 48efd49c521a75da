#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Symmetric matrices in envelope (skyline) storage: of every row, the numbers from its first nonzero to the
/// diagonal are stored; no other number becomes nonzero in L D Lᵀ. Suitable for rows of loops that couple
/// only to their neighbours.
namespace jw {

class EnvelopeMatrix {
public:
    EnvelopeMatrix() = default;
    /// @param first column of the first nonzero number of every row
    explicit EnvelopeMatrix(std::vector<int> first);

    int rows() const { return static_cast<int>(first_.size()); }
    int first(int row) const { return first_[static_cast<std::size_t>(row)]; }
    /// `column` lies between the row's first one and the diagonal.
    double& operator()(int row, int column) { return numbers_[index(row, column)]; }
    double operator()(int row, int column) const { return numbers_[index(row, column)]; }
    std::size_t index(int row, int column) const {
        return start_[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column - first(row));
    }
    std::span<double> numbers() { return numbers_; }

    /// Factors as L D Lᵀ in place; D replaces the unit diagonal of L.
    void factor();
    /// x = (L D Lᵀ)⁻¹ x
    void solve(double* x) const;

private:
    std::vector<int> first_;
    std::vector<std::size_t> start_;
    std::vector<double> numbers_;
};

}  // namespace jw
