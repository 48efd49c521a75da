#include <cmath>

#include <Eigen/Cholesky>

#include "core/motion/block/block_equations.hpp"
#include "core/numerics/svd.hpp"

/// Null space of the block equations' rows: all free motions, or a random one.
namespace jw {

namespace {

/// Relative threshold of singular values below which a motion is free.
constexpr double kFree = 1e-9;

}  // namespace

template <int B>
bool BlockEquations<B>::free_motion(
    double t, const double* y, std::span<const double> drawn, std::span<ProbedBody> bodies) {
    const bool anything_is_free = rows() - rows_left_out() < velocities();
    set_bodies(Content::jacobian, y);
    evaluate_links(Content::jacobian, t);
    factor_in_metric();
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        // rotations of 1 rad and displacements of one extent
        six_[k] = anything_is_free ? drawn[k] * (k % 6 < 3 ? extent_ : 1.0) : 0.0;
    }
    // twice: the first solution carries the rounding of what it removes
    for (int pass = 0; anything_is_free && pass < 2; ++pass) { take_out_rows(); }
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        bodies[m].free_way = vec3(&six_[6 * m]);
        bodies[m].free_turn = bodies_[at(moving_[m].body)].A * vec3(&six_[6 * m + 3]);
    }
    return true;
}

template <int B>
MatrixX BlockEquations<B>::free_motions(double t, const double* y) {
    set_bodies(Content::jacobian, y);
    evaluate_links(Content::jacobian, t);
    const auto columns = static_cast<Eigen::Index>(6 * moving_.size());
    MatrixX jacobian = MatrixX::Zero(static_cast<Eigen::Index>(nodes_.size()) * B, columns);
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        const Eigen::Map<const Eigen::Matrix<double, 6, B, Eigen::RowMajor>> j(&j_[side_at(side)]);
        jacobian.template block<B, 6>(
            static_cast<Eigen::Index>(n * B), static_cast<Eigen::Index>(6 * moving)) = j.transpose();
    });
    // coordinates in which M is the identity: x = Rᵀ q̇ with M = R Rᵀ. Where masses are far apart, this M
    // would hide constraints of heavy bodies
    MatrixX root = MatrixX::Zero(columns, columns);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto first = static_cast<Eigen::Index>(6 * m);
        root.template block<3, 3>(first, first)
            .diagonal()
            .setConstant(masses_apart_ ? 1.0 : std::sqrt(moving_[m].mass));
        root.template block<3, 3>(first + 3, first + 3) =
            masses_apart_ ? Mat3(extent_ * Mat3::Identity()) : Mat3(moving_[m].J.llt().matrixL());
    }
    const auto upper = root.transpose().template triangularView<Eigen::Upper>();
    if (nodes_.empty()) { return upper.solve(MatrixX::Identity(columns, columns)); }
    const MatrixX scaled =
        root.template triangularView<Eigen::Lower>().solve(jacobian.transpose()).transpose();
    const Svd svd = svd_of(scaled);
    const double largest = svd.sigma.size() > 0 ? svd.sigma(0) : 0.0;
    return upper.solve(svd.V.rightCols(columns - svd.rank(kFree * largest)));
}

template bool BlockEquations<3>::free_motion(
    double, const double*, std::span<const double>, std::span<ProbedBody>);
template MatrixX BlockEquations<3>::free_motions(double, const double*);
template bool BlockEquations<5>::free_motion(
    double, const double*, std::span<const double>, std::span<ProbedBody>);
template MatrixX BlockEquations<5>::free_motions(double, const double*);
template bool BlockEquations<6>::free_motion(
    double, const double*, std::span<const double>, std::span<ProbedBody>);
template MatrixX BlockEquations<6>::free_motions(double, const double*);

}  // namespace jw
