#include "core/poses/typed/smallest_changes.hpp"

#include <cmath>
#include <vector>

#include "core/numerics/svd.hpp"

namespace jw {

namespace {

// relative to the conditions, which are known to about nine digits of a change by half a unit
constexpr double kLeastSingular = 1e-9;

}  // namespace

std::optional<VectorX> smallest_changes(const MatrixX& A, const VectorX& b, double least_rest) {
    VectorX x = VectorX::Zero(A.cols());
    std::vector<bool> is_fixed(at(A.cols()), false);
    for (Eigen::Index round = 0; round < A.cols(); ++round) {
        VectorX rest = b;
        MatrixX free = A;
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            if (!is_fixed[at(k)]) { continue; }
            rest -= x(k) * A.col(k);
            free.col(k).setZero();
        }
        const Svd svd = svd_of(free);
        VectorX y = VectorX::Zero(A.cols());
        for (Eigen::Index k = 0; k < svd.sigma.size() && rest.norm() > least_rest; ++k) {
            if (svd.sigma(k) <= kLeastSingular * svd.sigma(0)) { break; }
            const double part = svd.U.col(k).dot(rest);
            rest -= part * svd.U.col(k);
            y += part / svd.sigma(k) * svd.V.col(k);
        }
        if (rest.norm() > 2.0 * least_rest) { return std::nullopt; }
        bool is_within = true;
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            if (is_fixed[at(k)]) { continue; }
            x(k) = y(k);
            if (std::abs(y(k)) <= 1.0) { continue; }
            x(k) = std::copysign(1.0, y(k));
            is_fixed[at(k)] = true;
            is_within = false;
        }
        if (is_within) { return x; }
    }
    return std::nullopt;
}

}  // namespace jw
