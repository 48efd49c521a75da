#include <catch2/catch.hpp>

#include <cmath>

#include "jointwise/evaluator.hpp"
#include "jointwise/lesson.hpp"
#include "jointwise/trajectory.hpp"

namespace jointwise::test {
namespace {

Mechanism lesson_mechanism(const std::string& name) {
    return read_lesson(JW_SOURCE_ROOT "/lessons/catalogue/" + name + ".toml").mechanism();
}

/// A body turned about x on a cylindrical joint whose axis is along z at the start.
Pose tilted(const Mechanism& m, double angle) {
    Pose pose = start_pose(m);
    pose.p[1] = {std::cos(angle / 2.0), std::sin(angle / 2.0), 0.0, 0.0};
    return pose;
}

}  // namespace

TEST_CASE("An evaluator that was used at other poses says what a new one says", "[api]") {
    const Mechanism m = lesson_mechanism("joints/screw");
    Evaluator used(m, Coordinates::omega_global);
    for (const Moment& moment : follow(m, {0.0, 0.3, 0.6})) {
        Evaluator fresh(m, Coordinates::omega_global);
        Equations again;
        Equations first;
        used.equations_at(moment.pose, moment.velocity, again);
        fresh.equations_at(moment.pose, moment.velocity, first);
        CHECK(again.rows == first.rows);
        CHECK(again.phi == first.phi);
        CHECK(again.jacobian == first.jacobian);
        CHECK(again.nu == first.nu);
        CHECK(again.gamma == first.gamma);
        CHECK(used.velocities_at(moment.pose).omega_local == fresh.velocities_at(moment.pose).omega_local);
        CHECK(used.rank_at(moment.pose).rank == fresh.rank_at(moment.pose).rank);
        CHECK(used.rows() == first.phi.size());
        CHECK(used.columns() == first.jacobian.cols());
        CHECK(used.column_names().size() == static_cast<std::size_t>(used.columns()));
    }
}

TEST_CASE("An evaluator keeps its rows until it is told to choose them anew", "[api]") {
    Mechanism m;
    m.add_body("rod", Vector3::Zero());
    m.add_body("sleeve", Vector3::Zero());
    m.add_joint("slide", "cylindrical", 1, 2, {.axis = Vector3::UnitZ()});
    Evaluator evaluator(m);
    const std::vector<std::string> before = evaluator.row_names();
    Equations e;
    const Pose pose = tilted(m, 1.5);  // z of the rod lies nearly along y
    evaluator.equations_at(pose, start_rates(m), e);
    CHECK(e.rows == before);
    CHECK(evaluator.choose_rows(pose));
    evaluator.equations_at(pose, start_rates(m), e);
    CHECK(e.rows == evaluator.row_names());
    CHECK(e.rows != before);
    CHECK_FALSE(evaluator.choose_rows(pose));
}

TEST_CASE("An evaluator keeps the mechanism of the moment when it was made", "[api]") {
    Mechanism m = lesson_mechanism("loops/four-bar");
    Evaluator evaluator(m);
    const int columns = evaluator.columns();
    m.add_body("later", Vector3::Zero());
    CHECK(evaluator.columns() == columns);
    CHECK(Evaluator(m).columns() == columns + 7);
    m = Mechanism();
    CHECK(
        evaluator.rank_at(evaluator.assemble(start_pose(lesson_mechanism("loops/four-bar")), 0.0))
            .redundant == 3);
}

TEST_CASE("Equations along a motion are those at its moments", "[api]") {
    const Mechanism m = lesson_mechanism("joints/screw");
    const Trajectory motion = follow_trajectory(m, {0.0, 0.2, 0.4});
    Evaluator evaluator(m, Coordinates::omega_local);
    const EquationsTable table = evaluator.equations_along(motion);
    REQUIRE(table.phi.rows() == 3);
    for (int k = 0; k < 3; ++k) {
        Equations e;
        const Moment moment = motion.moment(k);
        evaluator.equations_at(moment.pose, moment.velocity, e);
        CHECK(table.phi.row(k).transpose() == e.phi);
        CHECK(table.nu.row(k).transpose() == e.nu);
        CHECK(table.gamma.row(k).transpose() == e.gamma);
        for (Eigen::Index row = 0; row < e.jacobian.rows(); ++row) {
            CHECK(
                table.jacobian.row(k).segment(row * e.jacobian.cols(), e.jacobian.cols()) ==
                e.jacobian.row(row));
        }
    }
}

TEST_CASE("Rows of a trajectory are the moments of the same motion", "[api]") {
    const Mechanism m = lesson_mechanism("joints/screw");
    const std::vector<double> times{0.0, 0.2, 0.4};
    const std::vector<Moment> moments = follow(m, times);
    const Trajectory trajectory = follow_trajectory(m, times);
    REQUIRE(trajectory.times() == 3);
    CHECK(trajectory.q.cols() == 7 * static_cast<int>(m.body_names().size()) + 1);
    for (int k = 0; k < 3; ++k) {
        const Moment& expected = moments[static_cast<std::size_t>(k)];
        const Moment found = trajectory.moment(k);
        CHECK(found.pose.t == expected.pose.t);
        CHECK(found.pose.r == expected.pose.r);
        CHECK(found.pose.p == expected.pose.p);
        CHECK(found.pose.theta == expected.pose.theta);
        CHECK(found.velocity.omega_local == expected.velocity.omega_local);
        CHECK(found.acceleration.r_dot == expected.acceleration.r_dot);
        CHECK(found.acceleration.theta_dot == expected.acceleration.theta_dot);
    }
    CHECK_THROWS_AS(trajectory.moment(3), std::invalid_argument);
    CHECK_THROWS_AS(trajectory.moment(-1), std::invalid_argument);
}

}  // namespace jointwise::test
