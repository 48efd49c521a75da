#include <catch2/catch.hpp>

#include <cmath>

#include <Eigen/SVD>

#include "core/kinematics/proof/inverse.hpp"
#include "core/kinematics/proof/norm_bound.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

TEST_CASE(
    "The inverse of a matrix with many zeros is one, and a singular matrix has none", "[core][numerics]") {
    test::Random random(71);
    std::vector<Eigen::Index> pivots;
    for (Eigen::Index n = 1; n <= 40; ++n) {
        MatrixX m = MatrixX::Identity(n, n);
        // rows in another order, so that the pivots are not on the diagonal
        for (Eigen::Index k = 0; k < n; ++k) { m.row(k).swap(m.row((3 * k + 1) % n)); }
        for (Eigen::Index k = 0; k < 2 * n; ++k) { m(k * 7 % n, k * 5 % n) += 0.3 * random.number(); }
        MatrixX inverse = m;
        CAPTURE(n);
        REQUIRE(invert_in_place(inverse, pivots));
        // these matrices have condition numbers up to 1e4
        CHECK((m * inverse - MatrixX::Identity(n, n)).norm() < 1e-10);
        m.col(n - 1).setZero();
        CHECK_FALSE(invert_in_place(m, pivots));
    }
}

TEST_CASE("The bound of a block's norm is at most two per cent above it", "[core][numerics]") {
    test::Random random(72);
    for (int k = 0; k < 2000; ++k) {
        const Eigen::Index rows = 1 + k % 4;
        const Eigen::Index columns = 1 + k / 4 % 4;
        MatrixX block(rows, columns);
        for (double& x : block.reshaped()) { x = random.number() * std::pow(10.0, 3.0 * random.number()); }
        const double exact = Eigen::JacobiSVD<MatrixX>(block).singularValues()(0);
        CAPTURE(block);
        CHECK(norm_bound(block) >= exact);
        CHECK(norm_bound(block) <= 1.02 * exact);
    }
    CHECK(norm_bound(Mat4(Mat4::Identity())) == Approx(std::pow(2.0, 1.0 / 64.0)));
    CHECK(norm_bound(Mat4(Mat4::Zero())) == 0.0);
}
