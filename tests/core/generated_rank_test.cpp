#include <catch2/catch.hpp>

#include "core/poses/large_rank.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/position.hpp"
#include "tests/support/long_double_svd.hpp"
#include "tests/support/random_nets.hpp"
#include "tests/support/scenes.hpp"

using namespace jw;

namespace {

/// Jacobian in the scene's units, in which the rank is judged.
MatrixX scaled_jacobian_of(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    const Scaling scaling = scaling_of<OmegaLocal>(system);
    return scaling.row.cwiseInverse().asDiagonal() * test::jacobian_of<OmegaLocal>(mechanism) *
           scaling.column.asDiagonal();
}

/// Residual of a combination in long double, of the matrix as it stands: row − Σ coefficient · row, relative
/// to what is subtracted.
double miss_of(const test::MatrixL& J, const RedundantRow& redundant) {
    Eigen::Matrix<long double, 1, Eigen::Dynamic> rest = J.row(redundant.row);
    long double size = rest.norm();
    for (const RedundantRow::Term& term : redundant.terms) {
        rest -= static_cast<long double>(term.coefficient) * J.row(term.row);
        size += std::abs(term.coefficient) * J.row(term.row).norm();
    }
    return static_cast<double>(rest.norm() / size);
}

/// Puts a mechanism beside another, on a fixed body of its own.
void add_beside(Mechanism& all, const Mechanism& more) {
    const int bodies = static_cast<int>(all.bodies.size());
    const int joints = static_cast<int>(all.joints.size());
    all.bodies.insert(all.bodies.end(), more.bodies.begin(), more.bodies.end());
    for (Joint joint : more.joints) {
        joint.body_i = bodies + joint.body_i;
        joint.body_j = bodies + joint.body_j;
        all.joints.push_back(joint);
    }
    for (Driver driver : more.drivers) {
        driver.body_i = bodies + driver.body_i;
        driver.body_j = bodies + driver.body_j;
        if (driver.joint >= 0) { driver.joint += joints; }
        all.drivers.push_back(driver);
    }
}

}  // namespace

TEST_CASE("The rank of generated mechanisms is that of a long double Jacobi", "[core][rank]") {
    int decided = 0;
    int redundant = 0;
    constexpr int kMechanisms = 2500;
    for (unsigned seed = 1; seed <= kMechanisms; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = test::random_net(random);
        const MatrixX scaled = scaled_jacobian_of(mechanism);
        if (scaled.size() == 0) { continue; }
        const RankReport report = test::rank_of(mechanism);
        const VectorX exact = test::long_double_singular_values(scaled);
        CAPTURE(report.threshold, report.singular_value_error, report.pose_error);
        CHECK(report.sound);
        CHECK((report.singular_values - exact).cwiseAbs().maxCoeff() <= report.singular_value_error);
        const auto rank = std::ranges::count_if(exact, [&](double s) { return s > report.threshold; });
        if (report.decided) { CHECK(report.rank == rank); }
        decided += report.decided ? 1 : 0;
        redundant += report.redundant() > 0 ? 1 : 0;
    }
    // "cannot tell" is the exception: a singular value has to fall within 1e-14 of the threshold, or the pose
    // into the root of its residual
    CHECK(decided > kMechanisms * 98 / 100);
    CHECK(redundant > kMechanisms / 4);
}

TEST_CASE(
    "The verdict alone on many generated mechanisms at once is that of the whole analysis", "[core][rank]") {
    int squares = 0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        Mechanism all = test::random_net(random);
        // more columns than the limit up to which singular values are computed
        while (System(all, everything(all)).columns(3) <= 66) { add_beside(all, test::random_net(random)); }
        System system(all, everything(all));
        const State state = start_state(all);
        system.choose_rows(state);
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(state, 0.0);
        const RankReport whole = analyse_rank(system, assembler.jacobian(), assembler.phi());
        const RankReport verdict = analyse_rank_verdict(system, assembler.sparse_jacobian(), assembler.phi());
        squares += verdict.has_spectrum ? 0 : 1;
        if (!whole.decided || !verdict.decided) { continue; }
        CHECK(verdict.rank == whole.rank);
        CHECK(verdict.dof == whole.dof);
        CHECK(verdict.redundant() == whole.redundant());
        CHECK(verdict.assembled == whole.assembled);
        CHECK(verdict.first_value() == Approx(whole.first_value()).epsilon(1e-6));
        CHECK(verdict.last_value() == Approx(whole.last_value()).epsilon(1e-6));
    }
    CHECK(squares > 50);
}

TEST_CASE("Combinations and free motions of generated mechanisms hold in long double", "[core][rank]") {
    for (unsigned seed = 1; seed <= 2500; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = test::random_net(random);
        const test::MatrixL J = test::jacobian_of<OmegaLocal>(mechanism).cast<long double>();
        if (J.size() == 0) { continue; }
        const RankReport report = test::rank_of(mechanism);
        CAPTURE(report.threshold, report.singular_value_error);
        const System system(mechanism, everything(mechanism));
        for (const RedundantRow& row : report.redundant_rows) {
            CAPTURE(row.row, row.misfit, row.bound);
            CHECK(row.misfit <= row.bound);
            // for a row of size 1: at most what was taken as zero, plus terms of 1e-9 that are not reported
            CHECK(miss_of(J, row) <= 10.0 * (report.threshold + 1e-9));
        }
        REQUIRE(report.free_motion_proofs.size() == report.free_motions.size());
        for (std::size_t k = 0; k < report.free_motions.size(); ++k) {
            CAPTURE(k, report.free_motion_proofs[k].residual, report.free_motion_proofs[k].bound);
            CHECK(report.free_motion_proofs[k].holds());
            const Eigen::Matrix<long double, Eigen::Dynamic, 1> v =
                report.free_motions[k].cast<long double>();
            for (Eigen::Index row = 0; row < J.rows(); ++row) {
                const auto size = static_cast<long double>(system.row_unit(static_cast<int>(row)));
                // an elimination among few bodies amplifies errors by less than ten
                CHECK(std::abs(J.row(row).dot(v)) <= 10.0L * report.threshold * size * v.norm());
            }
        }
    }
}

TEST_CASE("All four choices of coordinates give generated mechanisms the same rank", "[core][rank]") {
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = test::random_net(random);
        const RankReport report = test::rank_of(mechanism);
        // nearly repeated equations stand at different distances from the threshold
        if (report.rows == 0 || report.largest_gap < 1e6) { continue; }
        const System system(mechanism, everything(mechanism));
        const auto rank_in = [&](auto choice, int normalisation_rows) {
            using C = decltype(choice);
            const Scaling scaling = scaling_of<C>(system);
            const MatrixX scaled = scaling.row.cwiseInverse().asDiagonal() * test::jacobian_of<C>(mechanism) *
                                   scaling.column.asDiagonal();
            const VectorX sigma = singular_values_of(scaled);
            const double last = report.singular_values(std::max(report.rank - 1, 0));
            // columns of p are up to four times those of ω; the gap has room for it
            return static_cast<int>(std::ranges::count_if(sigma, [&](double s) { return s > 1e-3 * last; })) -
                   normalisation_rows;
        };
        const int bodies = static_cast<int>(system.moving_bodies().size());
        CHECK(rank_in(TrueEulerParameters{}, bodies) == report.rank);
        CHECK(rank_in(ModifiedEulerParameters{}, bodies) == report.rank);
        CHECK(rank_in(OmegaGlobal{}, 0) == report.rank);
    }
}

TEST_CASE("A pose that is known too poorly to tell the rank says so", "[core][rank]") {
    const Mechanism mechanism = test::parallelogram(1e-5);
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    // σ_17 = 0.5e-5: a residual of 1e-14 lets the pose be off by 2e-9, one of 1e-11 by 2e-6, times 10
    for (const auto& [residual, decided] : {std::pair{1e-14, true}, {1e-11, false}}) {
        CAPTURE(residual);
        const RankReport report =
            analyse_rank(system, assembler.jacobian(), VectorX::Constant(assembler.phi().size(), residual));
        CHECK(report.rank == 17);
        CHECK(report.decided == decided);
    }
}

TEST_CASE(
    "At a change point that Newton has found no rank is claimed that the pose does not have",
    "[core][rank]") {
    int undecided = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        Mechanism mechanism = test::parallelogram(0.0);
        test::drive_angle(mechanism, 0, test::polynomial({0.0}));
        const System system(mechanism, everything(mechanism));
        State state = test::disturbed(mechanism, start_state(mechanism), random, 1e-4, 1e-4);
        if (!solve_position<OmegaLocal>(system, state, 0.0).ok()) { continue; }
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(state, 0.0);
        const RankReport report = analyse_rank(system, assembler.jacobian(), assembler.phi());
        CAPTURE(report.residual, report.pose_error, report.singular_values(report.rank - 1));
        // the driver adds one equation to the 16 that are independent where the parallelogram is flat
        if (report.decided) { CHECK(report.rank == 17); }
        undecided += report.decided ? 0 : 1;
    }
    CHECK(undecided > 0);
}
