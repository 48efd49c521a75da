#pragma once

#include "core/numerics/linear.hpp"

namespace jw::test {

inline MatrixX without_row(const MatrixX& matrix, int row) {
    MatrixX rest(matrix.rows() - 1, matrix.cols());
    rest << matrix.topRows(row), matrix.bottomRows(matrix.rows() - row - 1);
    return rest;
}

}  // namespace jw::test
