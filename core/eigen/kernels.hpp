#pragma once

#include <Eigen/Core>

/// Eigen's products of matrices of any size and its triangular solver: compiled once (kernels.cpp), not in
/// each source that multiplies. Instructions and results are the same. A kernel that is not listed is
/// compiled where it is used, as usual.
namespace Eigen::internal {

/// DO(specialization) for each of them: blocks of two packed matrices, matrix and vector, triangle and
/// matrix, solver.
// clang-format off
#define JW_EIGEN_KERNELS(DO)                                                                                           \
    DO(gebp_kernel<double, double, Index, blas_data_mapper<double, Index, ColMajor, Unaligned, 1>,                     \
                   gebp_traits<double, double>::mr, gebp_traits<double, double>::nr, false, false>)                    \
    DO(general_matrix_vector_product<Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false,  \
                                     double, const_blas_data_mapper<double, Index, ColMajor>, false, Specialized>)     \
    DO(general_matrix_vector_product<Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false,  \
                                     double, const_blas_data_mapper<double, Index, RowMajor>, false, Specialized>)     \
    DO(general_matrix_vector_product<Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false,  \
                                     double, const_blas_data_mapper<double, Index, ColMajor>, false, Specialized>)     \
    DO(general_matrix_vector_product<Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false,  \
                                     double, const_blas_data_mapper<double, Index, RowMajor>, false, BuiltIn>)         \
    DO(product_triangular_matrix_matrix<double, Index, Lower, true, ColMajor, false, ColMajor, false, ColMajor, 1, 0>) \
    DO(product_triangular_matrix_matrix<double, Index, Upper, true, RowMajor, false, ColMajor, false, ColMajor, 1, 0>) \
    DO(product_triangular_matrix_matrix<double, Index, UnitLower, true, ColMajor, false, ColMajor, false, ColMajor, 1, 0>) \
    DO(product_triangular_matrix_matrix<double, Index, UnitUpper, true, RowMajor, false, ColMajor, false, ColMajor, 1, 0>) \
    DO(triangular_solve_matrix<double, Index, OnTheLeft, Lower, false, ColMajor, ColMajor, 1>)                         \
    DO(triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor, 1>)                     \
    DO(triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>)
// clang-format on

#define JW_COMPILED_ELSEWHERE(...) extern template struct __VA_ARGS__;
JW_EIGEN_KERNELS(JW_COMPILED_ELSEWHERE)

}  // namespace Eigen::internal
