#include "core/numerics/sparse_rows.hpp"

namespace jw {

void SparseRows::multiply(const VectorX& x, VectorX& out) const {
    out.resize(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        double sum = 0.0;
        for_each_entry(rows[r], [&](int column, double value) { sum += value * x(column); });
        out(static_cast<Eigen::Index>(r)) = sum;
    }
}

VectorX SparseRows::transposed_times(const VectorX& lambda) const {
    VectorX out = VectorX::Zero(columns);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const double factor = lambda(static_cast<Eigen::Index>(r));
        for_each_entry(rows[r], [&](int column, double value) { out(column) += factor * value; });
    }
    return out;
}

void SparseRows::write(MatrixX& matrix) const {
    matrix.setZero();
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for_each_entry(
            rows[r], [&](int column, double value) { matrix(static_cast<Eigen::Index>(r), column) = value; });
    }
}

}  // namespace jw
