#include "core/svd.hpp"

template class Eigen::JacobiSVD<jw::MatrixX>;
template class Eigen::BDCSVD<jw::MatrixX>;
