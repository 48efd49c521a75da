#include "core/numerics/svd.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/lapack_svd.hpp"
#include "tests/support/long_double_svd.hpp"
#include "tests/support/random_nets.hpp"

using namespace jw;

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

double size_of(const MatrixX& A) { return static_cast<double>(std::max(A.rows(), A.cols())); }

/// Checks every guarantee of the decomposition, and compares the values with two other programs.
void check_against_others(const MatrixX& A) {
    const Svd svd = svd_of(A);
    CAPTURE(A.rows(), A.cols(), svd.misfit, svd.orthogonality, svd.norm_defect, svd.error);
    REQUIRE(svd.sound);
    const double largest = svd.sigma(0);
    const VectorX exact = test::long_double_singular_values(A);
    const VectorX lapack = test::lapack_singular_values(A);
    const double off = (svd.sigma - exact).cwiseAbs().maxCoeff();
    // the guaranteed error, which includes the worst case of all roundings of the check
    CHECK(off <= svd.error);
    // the error of Jacobi rotations: a few roundings of the largest singular value
    CHECK(off <= 10.0 * std::sqrt(size_of(A)) * kEps * largest);
    // the guaranteed error is at most worst-case rounding: n² of the largest, times a small factor
    CHECK(svd.error <= 10.0 * size_of(A) * size_of(A) * kEps * largest);
    // dgejsv has the same bound as ours
    CHECK((svd.sigma - lapack).cwiseAbs().maxCoeff() <= 20.0 * std::sqrt(size_of(A)) * kEps * largest);
    CHECK(std::ranges::is_sorted(svd.sigma, std::ranges::greater{}));
}

/// Checks the Jacobian in a choice of coordinates, its rows not scaled, as `inspect` shows it.
template <class C>
void check_jacobian(const Mechanism& mechanism) {
    const MatrixX J = test::jacobian_of<C>(mechanism);
    if (J.size() > 0) { check_against_others(J); }
}

MatrixX random_matrix(test::Random& random, Eigen::Index rows, Eigen::Index columns) {
    return MatrixX::NullaryExpr(rows, columns, [&] { return random.number(); });
}

}  // namespace

TEST_CASE(
    "Singular values of generated mechanisms equal those of LAPACK's dgejsv and of a long double Jacobi",
    "[core][svd]") {
    for (unsigned seed = 1; seed <= 1500; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = test::random_net(random);
        check_jacobian<TrueEulerParameters>(mechanism);
        check_jacobian<ModifiedEulerParameters>(mechanism);
        check_jacobian<OmegaLocal>(mechanism);
        check_jacobian<OmegaGlobal>(mechanism);
    }
}

TEST_CASE("Singular values of matrices of every shape equal those of two other programs", "[core][svd]") {
    for (unsigned seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const auto rows = static_cast<Eigen::Index>(random.number(1.0, 20.0));
        const auto columns = static_cast<Eigen::Index>(random.number(1.0, 20.0));
        MatrixX A = random_matrix(random, rows, columns) * std::pow(10.0, random.number(-100.0, 100.0));
        // some rows repeat others, some rows and columns are zero
        if (seed % 2 == 0) { A.row(rows - 1) = A.row(0); }
        if (seed % 3 == 0) { A.col(columns / 2).setZero(); }
        if (seed % 5 == 0) { A.row(rows / 2).setZero(); }
        if (A.isZero(0.0)) { continue; }
        check_against_others(A);
    }
}

TEST_CASE("Columns and rows of very different lengths cost no digit of the smallest values", "[core][svd]") {
    for (unsigned seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const auto n = static_cast<Eigen::Index>(random.number(2.0, 13.0));
        MatrixX A = random_matrix(random, n + 2, n);
        for (Eigen::Index k = 0; k < n; ++k) { A.col(k).normalize(); }
        const VectorX well = svd_of(A).sigma;
        const double condition = well(0) / well(n - 1);
        for (Eigen::Index k = 0; k < n; ++k) { A.col(k) *= std::pow(10.0, random.number(-15.0, 15.0)); }
        if (seed % 2 == 0) { A.transposeInPlace(); }
        const VectorX exact = test::long_double_singular_values(A);
        const VectorX sigma = svd_of(A).sigma;
        const VectorX lapack = test::lapack_singular_values(A);
        // the theorem: n roundings times the condition of the columns made equally long
        const double bound = 10.0 * static_cast<double>(n) * kEps * condition;
        CAPTURE(condition);
        CHECK((sigma - exact).cwiseQuotient(exact).cwiseAbs().maxCoeff() <= bound);
        CHECK((lapack - exact).cwiseQuotient(exact).cwiseAbs().maxCoeff() <= bound);
    }
}

TEST_CASE("V is orthogonal and its last columns are the null space, whatever the shape", "[core][svd]") {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const auto rows = static_cast<Eigen::Index>(random.number(1.0, 15.0));
        const auto columns = static_cast<Eigen::Index>(random.number(1.0, 15.0));
        const auto rank =
            static_cast<Eigen::Index>(random.number(0.0, 1.0 + static_cast<double>(std::min(rows, columns))));
        const MatrixX A = random_matrix(random, rows, rank) * random_matrix(random, rank, columns);
        const Svd svd = svd_of(A);
        // products of factors of size 1 have roundings of their sizes, at most 15
        const double rounding = 100.0 * kEps * (1.0 + A.norm());
        CHECK(svd.V.rows() == columns);
        CHECK(svd.V.cols() == columns);
        CHECK(svd.U.rows() == rows);
        CHECK(svd.rank(rounding) == rank);
        CHECK((A * svd.V.rightCols(columns - rank)).norm() <= rounding);
        CHECK((svd.V.transpose() * svd.V - MatrixX::Identity(columns, columns)).norm() <= 100.0 * kEps);
        CHECK(
            (svd.U * svd.sigma.asDiagonal() * svd.V.leftCols(svd.sigma.size()).transpose() - A).norm() <=
            rounding);
    }
}

TEST_CASE("A decomposition that is off by more than rounding does not pass its check", "[core][svd]") {
    test::Random random(7);
    const MatrixX A = random_matrix(random, 12, 9);
    const Svd right = svd_of(A);
    REQUIRE(right.sound);
    for (Eigen::Index k = 0; k < 9; ++k) {
        CAPTURE(k);
        Svd value = right;
        value.sigma(k) *= 1.0 + 1e-11;  // a hundred times what rounding does to a matrix of this size
        check_svd(A, value);
        CHECK_FALSE(value.sound);
        CHECK(value.error >= 1e-11 * right.sigma(k));

        Svd turned = right;
        turned.V.col(k) = right.V.col((k + 1) % 9);
        check_svd(A, turned);
        CHECK_FALSE(turned.sound);

        Svd stretched = right;
        stretched.U.col(k) *= 2.0;
        stretched.sigma(k) *= 0.5;
        check_svd(A, stretched);
        CHECK(stretched.misfit < 1e-14 * right.sigma(0) * 12.0);
        CHECK_FALSE(stretched.sound);
        CHECK(stretched.error >= 0.5 * right.sigma(k));
    }
}

TEST_CASE("Matrices without entries, without values and without numbers have an answer", "[core][svd]") {
    const Svd none = svd_of(MatrixX(0, 3));
    CHECK(none.sigma.size() == 0);
    CHECK(none.V.isIdentity(0.0));
    CHECK(none.sound);

    const Svd zero = svd_of(MatrixX::Zero(3, 5));
    CHECK(zero.sigma.isZero(0.0));
    CHECK(zero.error == 0.0);
    CHECK(zero.sound);

    MatrixX A = MatrixX::Identity(4, 4);
    A(2, 1) = std::numeric_limits<double>::quiet_NaN();
    const Svd nowhere = svd_of(A);
    CHECK_FALSE(nowhere.sound);
    CHECK(std::isinf(nowhere.error));
}
