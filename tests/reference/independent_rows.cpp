#include <algorithm>
#include <numeric>

#include "tests/reference/formulations.hpp"

namespace jw::reference {

std::vector<int> independent_rows(MatX S) {
    // redundant rows leave pivots of the rounding, 1e-18; independent ones of the scenes stay above 1e-4
    constexpr Real kRedundant = 1e-10L;
    const Eigen::Index n = S.rows();
    // a row that nothing can move, as across the plane of a planar tree, counts as redundant
    const VecX scale = S.diagonal().unaryExpr([](Real d) { return d > 0.0L ? 1.0L / std::sqrt(d) : 0.0L; });
    S = scale.asDiagonal() * S * scale.asDiagonal();
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    Eigen::Index kept = 0;
    for (; kept < n; ++kept) {
        Eigen::Index next = 0;
        if (S.diagonal().tail(n - kept).maxCoeff(&next) < kRedundant) { break; }
        next += kept;
        std::swap(order[static_cast<std::size_t>(kept)], order[static_cast<std::size_t>(next)]);
        S.row(kept).swap(S.row(next));
        S.col(kept).swap(S.col(next));
        const Eigen::Index rest = n - kept - 1;
        const VecX column = S.col(kept).tail(rest);
        S.bottomRightCorner(rest, rest) -= column * column.transpose() / S(kept, kept);
    }
    order.resize(static_cast<std::size_t>(kept));
    std::sort(order.begin(), order.end());
    return order;
}

}  // namespace jw::reference
