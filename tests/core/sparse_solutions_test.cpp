#include <catch2/catch.hpp>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/numerics/sparse_rank.hpp"
#include "core/poses/damped_step.hpp"
#include "core/poses/large_rank.hpp"
#include "core/poses/least_squares.hpp"
#include "tests/support/grown_mechanisms.hpp"

/// Sparse factors against dense ones that share no code with them, over generated mechanisms of 11 to 18
/// bodies: trees, loops, repeated joints, drivers, artificial coordinates.
using namespace jw;

namespace {

/// Φq at the start pose, as it is and scaled, with its singular values by Jacobi's method.
struct Case {
    explicit Case(const Mechanism& given)
        : mechanism(given),
          system(mechanism, everything(mechanism)),
          scaling(scaling_of<OmegaLocal>(system)) {
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
        rows = assembler.sparse_jacobian();
        phi = assembler.phi();
        scaled = scaling.row.cwiseInverse().asDiagonal() * assembler.jacobian() * scaling.column.asDiagonal();
        sigma = Eigen::JacobiSVD<MatrixX>(scaled).singularValues();
        while (rank < sigma.size() && sigma(rank) > 1e-9 * sigma(0)) { ++rank; }
    }
    double condition() const { return sigma(0) / sigma(rank - 1); }
    /// True if the matrix is not nearly singular and rounding does not decide its rank.
    bool is_clear() const {
        return condition() < 1e5 && (rank == sigma.size() || sigma(rank) < 1e-13 * sigma(0));
    }

    Mechanism mechanism;
    System system;
    Scaling scaling;
    SparseRows rows;
    VectorX phi;
    MatrixX scaled;
    VectorX sigma;
    Eigen::Index rank = 0;
};

Case grown(unsigned seed) {
    return Case(test::grown_mechanism(
        seed, 11 + static_cast<int>(seed % 8), static_cast<int>(seed % 5) + static_cast<int>(seed % 3)));
}

VectorX random_vector(test::Random& random, Eigen::Index size) {
    VectorX v(size);
    for (double& entry : v) { entry = random.number(); }
    return v;
}

}  // namespace

TEST_CASE("Sparse least squares are the dense ones, contradicting rows included", "[core][sparse]") {
    int clear = 0;
    int redundant = 0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        const Case c = grown(seed);
        if (!c.is_clear()) { continue; }
        ++clear;
        LeastSquares sparse(c.scaling);
        REQUIRE(sparse.is_sparse());
        sparse.compute(c.rows);
        REQUIRE(sparse.rank(1e-9) == c.rank);
        redundant += c.rank < c.scaled.rows() ? 1 : 0;

        test::Random random(seed);
        const VectorX consistent = c.scaled * random_vector(random, c.scaled.cols());
        const VectorX contradicting = random_vector(random, c.scaled.rows());
        Eigen::CompleteOrthogonalDecomposition<MatrixX> dense;
        dense.setThreshold(1e-9);
        dense.compute(c.scaled);
        for (const VectorX& b : {consistent, contradicting}) {
            const VectorX expected = dense.solve(b);
            VectorX x;
            sparse.solve(b.cwiseProduct(c.scaling.row), static_cast<int>(c.rank), x);
            x = x.cwiseQuotient(c.scaling.column);
            // least squares: rounding of some 1e-15 times the condition, squared where rows contradict
            const double condition = c.condition();
            const double error = 1e-13 * condition * (1.0 + (b - c.scaled * expected).norm() * condition);
            CHECK((x - expected).norm() <= error * (1.0 + expected.norm()));
        }
    }
    CHECK(clear > 150);
    CHECK(redundant > 80);
}

TEST_CASE("Sparse factors keep the free part of a motion and find what holds a force", "[core][sparse]") {
    for (unsigned seed = 2001; seed <= 2100; ++seed) {
        CAPTURE(seed);
        const Case c = grown(seed);
        if (!c.is_clear()) { continue; }
        LeastSquares sparse(c.scaling);
        sparse.compute(c.rows);
        const int rank = sparse.rank(1e-9);
        const Eigen::JacobiSVD<MatrixX> svd(c.scaled, Eigen::ComputeFullV);
        const MatrixX null = svd.matrixV().rightCols(c.scaled.cols() - c.rank);
        test::Random random(seed);
        const VectorX x = random_vector(random, c.scaled.cols());
        const VectorX expected = null * (null.transpose() * x);
        // rounding times the condition of the space
        const double error = 1e-13 * c.condition();

        VectorX free = x.cwiseProduct(c.scaling.column);
        sparse.keep_free_part(rank, free);
        CHECK((free.cwiseQuotient(c.scaling.column) - expected).norm() < error);

        VectorX lambda;
        sparse.solve_transposed(x.cwiseQuotient(c.scaling.column), rank, lambda);
        const VectorX held = c.scaled.transpose() * lambda.cwiseProduct(c.scaling.row);
        CHECK((x - held - expected).norm() < error * (1.0 + lambda.cwiseProduct(c.scaling.row).norm()));
    }
}

TEST_CASE("The sparse rank is that of the singular values, and its bounds hold", "[core][sparse][rank]") {
    int proved = 0;
    int all = 0;
    for (unsigned seed = 3001; seed <= 3300; ++seed) {
        CAPTURE(seed);
        const Case c = grown(seed);
        const RankReport dense = analyse_rank_of_any_size(c.system, c.rows, c.phi, true);
        std::vector<int> alone;
        for (int row = 0; row < c.system.rows(); ++row) { alone.push_back(row); }
        const SparseRank sparse =
            sparse_rank_of(c.rows, c.scaling.row, c.scaling.column, alone, kRankThreshold);
        ++all;
        CHECK(sparse.largest == Approx(c.sigma(0)).epsilon(0.05));
        if (!sparse.is_proved()) { continue; }
        ++proved;
        CHECK(sparse.rank == c.rank);
        CHECK(sparse.last_at_least <= c.sigma(c.rank - 1));
        if (c.rank < c.sigma.size()) { CHECK(sparse.next_at_most >= c.sigma(c.rank)); }

        // given joint by joint, the same rows are combinations of the same others
        const RankReport told = analyse_large_rank(c.system, c.rows, c.phi);
        CHECK(told.rank == dense.rank);
        CHECK(told.dof == dense.dof);
        CHECK(told.mobility_by_counting == dense.mobility_by_counting);
        CHECK(told.residual == dense.residual);
        REQUIRE(told.redundant_rows.size() == dense.redundant_rows.size());
        if (!c.is_clear()) { continue; }
        for (std::size_t k = 0; k < told.redundant_rows.size(); ++k) {
            const RedundantRow& row = told.redundant_rows[k];
            CHECK(row.misfit <= row.bound);
            // the sum of the terms is the row
            VectorX difference = -c.scaled.row(row.row).transpose() * c.scaling.row(row.row);
            for (const RedundantRow::Term& term : row.terms) {
                difference += term.coefficient * c.scaling.row(term.row) * c.scaled.row(term.row).transpose();
            }
            // terms below 1e-9 of the largest are left out
            double largest = 1.0;
            for (const RedundantRow::Term& term : row.terms) {
                largest = std::max(largest, std::abs(term.coefficient));
            }
            CHECK(difference.cwiseAbs().maxCoeff() < 1e-7 * largest);
        }
    }
    // the others are near the threshold, where only singular values decide
    CHECK(proved > all * 9 / 10);
}

TEST_CASE("Chains and ladders have the rank that theory says", "[core][sparse][rank]") {
    for (const int n : {12, 40, 150}) {
        CAPTURE(n);
        const Case chain(test::hinge_chain(std::min(n, 40)));
        const RankReport of_chain = analyse_large_rank(chain.system, chain.rows, chain.phi);
        CHECK_FALSE(of_chain.has_spectrum);
        CHECK(of_chain.rank == 5 * std::min(n, 40));
        CHECK(of_chain.redundant() == 0);

        // n planar loops: three redundant equations each, one freedom in all
        const Mechanism mechanism = test::parallelogram_ladder(n);
        const System system(mechanism, everything(mechanism));
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
        const RankReport ladder = analyse_large_rank(system, assembler.sparse_jacobian(), assembler.phi());
        CHECK_FALSE(ladder.has_spectrum);
        CHECK(ladder.dof == 1);
        CHECK(ladder.redundant() == 3 * n);
        CHECK(static_cast<int>(ladder.redundant_rows.size()) == 3 * n);
        // rounding explains what the combinations leave: lengths of 1, and n loops in each at most
        for (const RedundantRow& row : ladder.redundant_rows) {
            CHECK(row.misfit <= row.bound);
            CHECK(row.bound < 1e-9);
        }
    }
}

TEST_CASE("Sparse damped steps are the dense ones, whatever the damping and the rank", "[core][sparse]") {
    double worst = 0.0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const Case c = grown(seed);
        test::Random random(seed);
        const VectorX phi = random_vector(random, c.scaled.rows());
        for (const double damping : {1e-15, 1e-9, 1e-3, 1e3, 1e12}) {
            CAPTURE(seed, damping);
            const VectorX dense =
                dense_damped_step(c.rows, c.scaling, phi, damping).cwiseQuotient(c.scaling.column);
            const VectorX sparse =
                sparse_damped_step(c.rows, c.scaling, phi, damping).cwiseQuotient(c.scaling.column);
            // least squares of [J; s I] Δ = [-Φ; 0]: what rounding may do to Δ, by Wedin
            const double s = std::sqrt(damping * std::max(1.0, c.scaled.colwise().squaredNorm().maxCoeff()));
            const double size = std::hypot(c.sigma(0), s);
            const double condition =
                size / std::hypot(c.rank == c.scaled.cols() ? c.sigma(c.rank - 1) : 0.0, s);
            const double left = std::hypot((c.scaled * dense + phi).norm(), s * dense.norm());
            const double sensitivity = condition + condition * condition * left / (size * dense.norm());
            const double error = (sparse - dense).norm() / dense.norm();
            worst = std::max(worst, error / sensitivity / std::numeric_limits<double>::epsilon());
        }
    }
    // in units of rounding: sums of about a hundred products, by two methods
    CAPTURE(worst);
    CHECK(worst < 100.0);
    CHECK(worst > 0.01);
}
