#pragma once

#include <Eigen/SVD>

#include "core/linear.hpp"

/// Singular values of dense matrices: Eigen's own, compiled once (svd.cpp). Every file that did so by itself
/// took half a minute longer to compile.
extern template class Eigen::JacobiSVD<jw::MatrixX>;
extern template class Eigen::BDCSVD<jw::MatrixX>;
