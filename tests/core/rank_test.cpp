#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

#include "tests/support/scenes.hpp"

using namespace jw;
using test::kPi;
using test::radians;

namespace {

const test::JointNames kRscr{"revolute", "spherical", "cylindrical", "revolute"};

struct Expected {
    const char* name;
    Mechanism mechanism;
    int rows, columns, rank;
    double smallest;  ///< lower bound of the nonzero singular values, from the table of docs/notation.md
};

std::vector<Expected> table() {
    return {
        {"four-bar", test::four_bar_at(0.7), 20, 18, 17, 0.3},
        {"four-bar R-S-C-R", test::four_bar_at(0.7, {}, kRscr), 17, 18, 17, 0.3},
        {"slider-crank", test::slider_crank(1.0, 3.0, 0.7), 20, 18, 17, 0.3},
        {"Bennett, 30 deg", test::bennett(radians(30.0)), 20, 18, 17, 0.3},
        {"Bennett, 90 deg", test::bennett(radians(90.0)), 20, 18, 17, 0.3},
        {"Bennett, 145 deg", test::bennett(radians(145.0)), 20, 18, 17, 0.3},
        {"Bricard, 68 deg", test::bricard(radians(68.0)), 30, 30, 29, 0.2},
        {"Bricard, 90 deg", test::bricard(radians(90.0)), 30, 30, 29, 0.2},
        {"RSSR", test::rssr(0.7), 16, 18, 16, 0.2},
        {"universal on bearings", test::cardan(0.5, 0.3), 14, 12, 11, 0.2},
        {"universal, straight", test::cardan(0.0, 0.3), 14, 12, 11, 0.2},
        {"universal, 90 deg", test::cardan(0.5 * kPi, 0.3), 14, 12, 11, 0.2},
        {"universal, 90 deg, branches cross", test::cardan(0.5 * kPi, 0.0), 14, 12, 10, 0.2},
        {"double Cardan", test::double_cardan(0.4, 0.3), 17, 18, 17, 0.2},
        {"double Cardan, straight", test::double_cardan(0.0, 0.3), 17, 18, 17, 0.2},
        {"parallelogram", test::parallelogram(1.0), 20, 18, 17, 0.3},
        {"parallelogram, collinear", test::parallelogram(0.0), 20, 18, 16, 0.3}};
}

void check_verdict(const Expected& expected, const RankReport& report) {
    CHECK(report.rows == expected.rows);
    CHECK(report.columns == expected.columns);
    CHECK(report.rank == expected.rank);
    CHECK(report.dof == expected.columns - expected.rank);
    CHECK(report.redundant() == expected.rows - expected.rank);
    CHECK(static_cast<int>(report.redundant_rows.size()) == report.redundant());
    CHECK(static_cast<int>(report.free_motions.size()) == report.dof);
    CHECK(report.mobility_by_counting == expected.columns - expected.rows);
    CHECK(report.assembled);
    CHECK_FALSE(report.near_singular);
}

}  // namespace

TEST_CASE("The closed loops of the lecture have the tabled ranks", "[core][rank]") {
    for (const Expected& expected : table()) {
        CAPTURE(expected.name);
        const RankReport report = test::rank_of(expected.mechanism);
        check_verdict(expected, report);
        CHECK(report.residual < 1e-14);  // the closed forms of the scenes satisfy the equations
        CHECK(report.singular_values(report.rank - 1) > expected.smallest);
        // the other singular values are rounding, 1e-16 times the number of rows: none lies in between
        CHECK(report.largest_gap > 1e12);
    }
}

TEST_CASE("Every redundant row is the combination that the report gives, of rows before it", "[core][rank]") {
    for (const Expected& expected : table()) {
        const MatrixX J = test::jacobian_of<OmegaLocal>(expected.mechanism);
        const RankReport report = test::rank_of(expected.mechanism);
        for (const RedundantRow& redundant : report.redundant_rows) {
            CAPTURE(expected.name, redundant.row);
            Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(J.cols());
            for (const RedundantRow::Term& term : redundant.terms) {
                sum += term.coefficient * J.row(term.row);
            }
            // assembled to rounding; terms below 1e-9 of the largest were left out
            CHECK((sum - J.row(redundant.row)).cwiseAbs().maxCoeff() < 1e-9);
            CHECK(redundant.misfit < 1e-12);
            CHECK_FALSE(redundant.terms.empty());
        }
    }
}

TEST_CASE("Every free motion satisfies all velocity equations, and they are independent", "[core][rank]") {
    for (const Expected& expected : table()) {
        CAPTURE(expected.name);
        const MatrixX J = test::jacobian_of<OmegaLocal>(expected.mechanism);
        const RankReport report = test::rank_of(expected.mechanism);
        MatrixX motions(report.columns, report.dof);
        for (int k = 0; k < report.dof; ++k) {
            motions.col(k) = report.free_motions[static_cast<std::size_t>(k)];
            CHECK(motions.col(k).maxCoeff() == Approx(1.0).epsilon(1e-15));
        }
        // rounding of singular vectors over the smallest singular value
        CHECK((J * motions).cwiseAbs().maxCoeff() < 1e-12);
        CHECK(singular_values_of(motions)(report.dof - 1) > 0.1);
    }
}

TEST_CASE("One free motion of RSSR is the idle spin of the rod alone", "[core][rank]") {
    const Mechanism mechanism = test::rssr(0.7);
    const RankReport report = test::rank_of(mechanism);
    REQUIRE(report.dof == 2);
    const auto touches_rod_only = [](const FreeMotion& motion) {
        return motion.segment<6>(0).norm() < 1e-12 && motion.segment<6>(12).norm() < 1e-12;
    };
    const auto spin = std::ranges::find_if(report.free_motions, touches_rod_only);
    REQUIRE(spin != report.free_motions.end());
    const Vec3 rod = test::Rssr{}.rocker_end(test::Rssr{}.psi(0.7)) - test::Rssr{}.crank_end(0.7);
    const Vec3 omega = rotation_matrix(mechanism.bodies[2].p) * spin->segment<3>(9);
    CHECK(omega.cross(rod).norm() < 1e-12 * rod.norm());
}

TEST_CASE("Turning and moving the whole scene changes no verdict", "[core][rank]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        const Vec4 p = random.unit_p();
        const Vec3 r = random.vector(3.0);
        for (Expected& expected : table()) {
            CAPTURE(seed, expected.name);
            const VectorX before = test::rank_of(expected.mechanism).singular_values;
            expected.mechanism = moved_rigidly(std::move(expected.mechanism), p, r);
            check_verdict(expected, test::rank_of(expected.mechanism));
            // with the pair form, which has no preferred global axes, even the singular values stay
            for (Joint& joint : expected.mechanism.joints) { joint.parallel_form = ParallelForm::pair; }
            const VectorX moved = test::rank_of(expected.mechanism).singular_values;
            for (Expected& original : table()) {
                if (std::string_view(original.name) != expected.name) { continue; }
                for (Joint& joint : original.mechanism.joints) { joint.parallel_form = ParallelForm::pair; }
                const VectorX unmoved = test::rank_of(original.mechanism).singular_values;
                CHECK((moved - unmoved).cwiseAbs().maxCoeff() < 1e-12 * unmoved(0));
            }
            CHECK(before.size() == moved.size());
        }
    }
}

TEST_CASE("Scaling all lengths from 1e-3 to 1e3 changes no verdict", "[core][rank]") {
    for (const double factor : {1e-3, 0.02, 0.3, 7.0, 200.0, 1e3}) {
        for (Expected& expected : table()) {
            CAPTURE(factor, expected.name);
            const RankReport before = test::rank_of(expected.mechanism);
            expected.mechanism = scaled(std::move(expected.mechanism), factor);
            const RankReport after = test::rank_of(expected.mechanism);
            check_verdict(expected, after);
            // the scene's unit changes in steps of 1000; after such a step the singular values are the same
            if (factor == 1e-3 || factor == 1e3) {
                CHECK(
                    (after.singular_values - before.singular_values).cwiseAbs().maxCoeff() <
                    1e-12 * before.singular_values(0));
            }
        }
    }
}

TEST_CASE(
    "(r, p) without normalisation rows hides redundancy, with them it is the kinematic rank plus bodies",
    "[core][rank]") {
    const auto rank_of_matrix = [](const MatrixX& matrix) {
        const VectorX sigma = singular_values_of(matrix);
        return static_cast<int>((sigma.array() > 1e-9 * sigma(0)).count());
    };
    struct Line {
        Mechanism mechanism;
        int bodies, rows, shown, real;
    };
    for (const Line& line :
         {Line{test::bennett(1.0), 3, 20, 20, 17}, Line{test::bricard(1.2), 5, 30, 30, 29},
          Line{test::cardan(0.5, 0.3), 2, 14, 13, 11}}) {
        CAPTURE(line.rows, line.real);
        for (const MatrixX& J :
             {test::jacobian_of<TrueEulerParameters>(line.mechanism),
              test::jacobian_of<ModifiedEulerParameters>(line.mechanism)}) {
            CHECK(rank_of_matrix(J.topRows(line.rows)) == line.shown);
            CHECK(rank_of_matrix(J) == line.real + line.bodies);
        }
        CHECK(rank_of_matrix(test::jacobian_of<OmegaGlobal>(line.mechanism)) == line.real);
        CHECK(test::rank_of(line.mechanism).rank == line.real);
    }
}

TEST_CASE("An equation without any derivative is redundant and repeats nothing", "[core][rank]") {
    test::SceneBuilder scene;
    const int rod = scene.add_body("rod", Vec3(0.4, 0.1, -0.2));
    // d·d = L² with both points together: d = 0, so all its derivatives vanish
    scene.add_distance(0, rod, Vec3(0.3, 0.2, 0.1), Vec3(0.3, 0.2, 0.1));
    const RankReport report = test::rank_of(scene.mechanism);
    CHECK(report.rank == 0);
    CHECK(report.dof == 6);
    REQUIRE(report.redundant_rows.size() == 1);
    CHECK(report.redundant_rows[0].terms.empty());
}
