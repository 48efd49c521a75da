#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/scenes.hpp"

/// Rank near the poses where it changes, and at poses that are assembled with limited accuracy.
using namespace jw;
using test::kPi;

TEST_CASE("Near its change point the parallelogram loses σ17 as 0.522 |sin φ|, σ16 stays", "[core][rank]") {
    for (const double offset : {1e-3, 1e-4, 1e-5, 1e-6}) {
        for (const double phi : {offset, -offset, kPi + offset}) {
            CAPTURE(phi);
            const RankReport report = test::rank_of(test::parallelogram(phi));
            CHECK(report.rank == 17);
            // three digits are given; next order and the rounding 1e-16 / 1e-6 are below them
            CHECK(report.singular_values(16) / std::abs(std::sin(phi)) == Approx(0.522).epsilon(1e-3));
            CHECK(report.singular_values(15) == Approx(phi < 1.0 ? 0.71 : 0.53).epsilon(0.01));
            CHECK(report.near_singular == (offset < 1.2e-3));
        }
    }
    for (const double phi : {0.0, kPi}) {
        CAPTURE(phi);
        const RankReport report = test::rank_of(test::parallelogram(phi));
        CHECK(report.rank == 16);
        CHECK(report.dof == 2);
        CHECK(report.singular_values(16) < 1e-15);
    }
}

TEST_CASE("A four-bar 3-1-2-2 has its change point at φ = π", "[core][rank]") {
    // stretched: crank 1 at π, ground 3, coupler 2, rocker 2: 1 + 3 = 2 + 2
    const test::FourBarLengths lengths{1.0, 2.0, 2.0, 3.0};
    const RankReport at =
        test::rank_of(test::four_bar(Vec3(-1.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)));
    CHECK(at.rank == 16);
    CHECK(at.singular_values(16) < 1e-15);
    const double slope = test::rank_of(test::four_bar_at(kPi - 1e-2, lengths)).singular_values(16) / 1e-2;
    for (const double offset : {1e-3, 1e-4}) {
        CAPTURE(offset);
        const RankReport report = test::rank_of(test::four_bar_at(kPi - offset, lengths));
        CHECK(report.rank == 17);
        // linear in the angle: second order is 1e-2 relative
        CHECK(report.singular_values(16) / offset == Approx(slope).epsilon(2e-2));
        CHECK(report.singular_values(15) > 0.4);
    }
}

TEST_CASE("A driver on the crank does not restore uniqueness at the change point", "[core][rank]") {
    for (const double phi : {0.0, 1.0}) {
        CAPTURE(phi);
        Mechanism mechanism = test::parallelogram(phi);
        test::drive_angle(mechanism, 0, test::polynomial({phi}));
        const RankReport report = test::rank_of(mechanism);
        CHECK(report.columns == 18);
        CHECK(report.rank == (phi == 0.0 ? 17 : 18));
    }
}

TEST_CASE("Position errors up to 1e-6 do not pass for rank", "[core][rank]") {
    for (const double error : {1e-12, 1e-10, 1e-8, 1e-6}) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            test::Random random(seed);
            const Mechanism mechanism = test::bennett(1.1);
            const System system(mechanism, everything(mechanism));
            Assembler<OmegaLocal> assembler(system);
            const State state = test::disturbed(mechanism, start_state(mechanism), random, error, error);
            assembler.assemble_phi_and_jacobian(state, 0.0);
            const RankReport report = analyse_rank(system, assembler.jacobian(), assembler.phi());
            CAPTURE(error, seed);
            CHECK(report.rank == 17);
            CHECK(report.assembled);
            // the value that should vanish is of the size of the error
            CHECK(report.singular_values(17) < 10.0 * error);
            for (const RedundantRow& row : report.redundant_rows) {
                // the combinations hold as accurately as the pose is assembled
                CHECK(row.misfit < 100.0 * error);
            }
        }
    }
}

TEST_CASE("A pose far from assembled is said to be so", "[core][rank]") {
    test::Random random(2);
    const Mechanism mechanism = test::bennett(1.1);
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(
        test::disturbed(mechanism, start_state(mechanism), random, 0.2, 0.2), 0.0);
    const RankReport report = analyse_rank(system, assembler.jacobian(), assembler.phi());
    CHECK_FALSE(report.assembled);
    CHECK(report.rank == 18);  // rank of the matrix there, in which only two rows are redundant
    CHECK(report.redundant() == 2);
}

TEST_CASE("A universal joint loses rank only with parallel arms", "[core][rank]") {
    for (const double degrees : {90.0, 10.0, 0.0}) {
        const double angle = test::radians(degrees);
        test::SceneBuilder scene;
        const int body = scene.add_body("body", Vec3::Zero());
        scene.add_universal(
            0, body, Vec3::Zero(), Vec3::UnitX(), Vec3(std::cos(angle), std::sin(angle), 0.0));
        const RankReport report = test::rank_of(scene.mechanism);
        CAPTURE(degrees);
        CHECK(report.singular_values(0) == Approx(1.0).epsilon(1e-14));
        CHECK(std::abs(report.singular_values(3) - std::sin(angle)) < 1e-15 * 10.0);
        CHECK(report.rank == (degrees == 0.0 ? 3 : 4));
    }
}

TEST_CASE("n2, p2 and what is made of them keep their rank where d vanishes", "[core][rank]") {
    struct Line {
        const char* type;
        int rank;
    };
    for (const Line& line : {Line{"n2", 1}, Line{"p2", 2}, Line{"cylindrical", 4}, Line{"prismatic", 5}}) {
        CAPTURE(line.type);
        test::SceneBuilder scene;
        const int body = scene.add_body("body", Vec3(0.4, 0.1, 0.7));
        scene.add_joint(line.type, 0, body, Vec3(1.0, 2.0, -1.0), Vec3(2.0, 3.0, 6.0));
        CHECK(test::rank_of(scene.mechanism).rank == line.rank);
    }
}

TEST_CASE("A scene without equations has all its freedoms", "[core][rank]") {
    test::SceneBuilder scene;
    scene.add_body("a", Vec3::Zero());
    scene.add_body("b", Vec3::UnitX());
    const RankReport report = test::rank_of(scene.mechanism);
    CHECK(report.rank == 0);
    CHECK(report.dof == 12);
    CHECK(report.free_motions.size() == 12);
    CHECK(report.redundant_rows.empty());
}
