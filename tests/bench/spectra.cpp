#include <array>
#include <cstdio>

#include <Eigen/SVD>

#include "core/numerics/svd.hpp"
#include "tests/bench/clock.hpp"
#include "tests/support/dynamics_scenes.hpp"
#include "tests/support/lapack_svd.hpp"
#include "tests/support/scene_builder.hpp"

/// `spectra`: milliseconds of singular values with U and V, checked, by core; by Eigen's BDCSVD, unchecked;
/// and by LAPACK's dgejsv without vectors.
namespace {

using namespace jw;

MatrixX jacobian_of(const Lesson& lesson, bool euler_parameters) {
    return euler_parameters ? test::jacobian_of<ModifiedEulerParameters>(lesson.mechanism)
                            : test::jacobian_of<OmegaLocal>(lesson.mechanism);
}

/// Time of one decomposition [ms]; small ones are repeated until they can be measured.
template <class F>
double milliseconds(Eigen::Index columns, F&& decompose) {
    const int count = columns > 100 ? 1 : static_cast<int>(20'000 / (columns * columns));
    return 1e-3 / count * least_time([&] {
               for (int k = 0; k < count; ++k) { decompose(); }
           });
}

void measure(const char* name, const MatrixX& A) {
    const double own = milliseconds(A.cols(), [&] { svd_of(A); });
    const double eigen = milliseconds(
        A.cols(), [&] { const Eigen::BDCSVD<MatrixX> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV); });
    const double lapack = milliseconds(A.cols(), [&] { test::lapack_singular_values(A); });
    std::printf(
        "%-12s%5d x%4d%12.4f%12.4f%12.4f%10.2f%10.2f\n", name, static_cast<int>(A.rows()),
        static_cast<int>(A.cols()), own, eigen, lapack, own / eigen, own / lapack);
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::printf("ms                 matrix        core      BDCSVD      dgejsv  c/BDCSVD  c/dgejsv\n");
    for (const int bodies : {1, 3, 7, 14, 35, 100}) {
        // three bodies in (r, p) have 21 columns
        measure("hinge chain", jacobian_of(test::chain(test::ChainJoint::revolute, bodies), bodies == 3));
    }
    for (const int windows : {1, 3, 17, 49}) {
        measure("n four-bar", jacobian_of(test::n_four_bar(windows), false));
    }
    return 0;
}
