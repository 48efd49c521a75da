#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "core/eigen/kernels.hpp"

/// Eigen's decompositions of matrices of any size, compiled once, like its kernels. Sources include this
/// header instead of <Eigen/QR> and the like.
namespace Eigen {

/// FUNCTION(member) for each member with the work of a decomposition. Whole classes would compile members
/// that nobody calls, for twice the time.
// clang-format off
#define JW_EIGEN_DECOMPOSITIONS(FUNCTION)                                                                              \
    FUNCTION(void ColPivHouseholderQR<MatrixXd>::computeInPlace())                                                     \
    FUNCTION(void HouseholderQR<MatrixXd>::computeInPlace())                                                           \
    FUNCTION(void CompleteOrthogonalDecomposition<MatrixXd>::computeInPlace())                                         \
    FUNCTION(void PartialPivLU<MatrixXd>::compute())                                                                   \
    FUNCTION(void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const)                        \
    FUNCTION(void HouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const)                              \
    FUNCTION(void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const)            \
    FUNCTION(void PartialPivLU<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const)                               \
    FUNCTION(void LDLT<MatrixXd, Lower>::_solve_impl(const VectorXd&, VectorXd&) const)                                \
    FUNCTION(LDLT<MatrixXd, Lower>& LDLT<MatrixXd, Lower>::compute(const EigenBase<MatrixXd>&))                        \
    FUNCTION(SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, int))
// clang-format on

#define JW_COMPILED_IN_DECOMPOSITIONS(...) extern template __VA_ARGS__;
JW_EIGEN_DECOMPOSITIONS(JW_COMPILED_IN_DECOMPOSITIONS)

}  // namespace Eigen

namespace jw {

/// Multiplies `m` by Q in place, for Q = householderQ() of a decomposition A = Q R. Eigen defines such
/// products in its classes, where a compiler has to read them for each source.
void multiply_by_q(const Eigen::HouseholderSequence<Eigen::MatrixXd, Eigen::VectorXd>& Q, Eigen::MatrixXd& m);
/// The first columns of Q, as many as `A` has: an orthonormal basis of the columns of `A` if they have full
/// rank.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& A);
/// Inverse and determinant of a square matrix, by its LU decomposition.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& m);
double determinant_of(const Eigen::MatrixXd& m);

}  // namespace jw
