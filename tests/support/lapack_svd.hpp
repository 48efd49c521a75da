#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <lapacke.h>

#include "core/numerics/linear.hpp"

/// Singular values by LAPACK: the same mathematics as core/numerics/svd, written by others in Fortran.
namespace jw::test {

/// Singular values by dgejsv, which has relative accuracy; largest first.
inline VectorX lapack_singular_values(const MatrixX& matrix) {
    // dgejsv wants at least as many rows as columns
    MatrixX A = matrix.rows() < matrix.cols() ? MatrixX(matrix.transpose()) : matrix;
    const auto rows = static_cast<lapack_int>(A.rows());
    const auto columns = static_cast<lapack_int>(A.cols());
    VectorX sigma(columns);
    std::vector<double> statistics(7);
    std::vector<lapack_int> counts(3);
    double unused = 0.0;
    // C: relative accuracy for columns of any scale; N, N: no vectors; N: nothing below a threshold is
    // dropped
    const lapack_int info = LAPACKE_dgejsv(
        LAPACK_COL_MAJOR, 'C', 'N', 'N', 'N', 'N', 'N', rows, columns, A.data(), rows, sigma.data(), &unused,
        1, &unused, 1, statistics.data(), counts.data());
    if (info != 0) { throw std::runtime_error("dgejsv failed with " + std::to_string(info)); }
    return sigma * (statistics[0] / statistics[1]);
}

}  // namespace jw::test
