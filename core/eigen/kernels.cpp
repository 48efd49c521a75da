#include "core/eigen/kernels.hpp"

namespace Eigen::internal {

#define JW_COMPILED_HERE(...) template struct __VA_ARGS__;
JW_EIGEN_KERNELS(JW_COMPILED_HERE)

}  // namespace Eigen::internal
