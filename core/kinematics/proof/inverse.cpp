#include "core/kinematics/proof/inverse.hpp"

#include <cmath>
#include <utility>

namespace jw {

bool invert_in_place(MatrixX& m, std::vector<Eigen::Index>& pivots) {
    const Eigen::Index n = m.rows();
    pivots.clear();
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::Index pivot = k;
        for (Eigen::Index row = k + 1; row < n; ++row) {
            if (std::abs(m(row, k)) > std::abs(m(pivot, k))) { pivot = row; }
        }
        if (m(pivot, k) == 0.0) { return false; }
        pivots.push_back(pivot);
        const double inverse = 1.0 / m(pivot, k);
        double* __restrict of_pivot = m.data() + n * k;
        std::swap(of_pivot[k], of_pivot[pivot]);
        for (Eigen::Index c = 0; c < n; ++c) {
            if (c == k) { continue; }
            double* __restrict column = m.data() + n * c;
            std::swap(column[k], column[pivot]);
            const double share = column[k] * inverse;
            if (share == 0.0) { continue; }
            for (Eigen::Index row = 0; row < n; ++row) { column[row] -= share * of_pivot[row]; }
            column[k] = share;
        }
        for (Eigen::Index row = 0; row < n; ++row) { of_pivot[row] *= -inverse; }
        of_pivot[k] = inverse;
    }
    for (Eigen::Index k = n; k-- > 0;) {
        if (pivots[at(k)] != k) { m.col(k).swap(m.col(pivots[at(k)])); }
    }
    return true;
}

}  // namespace jw
