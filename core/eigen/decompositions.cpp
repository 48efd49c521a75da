#include "core/eigen/decompositions.hpp"

namespace Eigen {

#define JW_COMPILED_HERE(...) template __VA_ARGS__;
JW_EIGEN_DECOMPOSITIONS(JW_COMPILED_HERE)

}  // namespace Eigen

namespace jw {

void multiply_by_q(
    const Eigen::HouseholderSequence<Eigen::MatrixXd, Eigen::VectorXd>& Q, Eigen::MatrixXd& m) {
    m.applyOnTheLeft(Q);
}

Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& A) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
    return qr.householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.cols());
}

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& m) { return m.inverse(); }
double determinant_of(const Eigen::MatrixXd& m) { return m.determinant(); }

}  // namespace jw
