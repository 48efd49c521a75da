#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "jointwise/analysis.hpp"
#include "jointwise/lesson.hpp"

namespace jointwise::test {
namespace {

std::string catalogue(const std::string& name) {
    return std::string(JW_SOURCE_ROOT) + "/lessons/catalogue/" + name;
}

}  // namespace

TEST_CASE("The four-bar of the lectures has twenty equations of rank seventeen", "[api]") {
    const Lesson lesson = read_lesson(catalogue("loops/four-bar.toml"));
    const Rank rank = rank_at(lesson.mechanism(), assemble(lesson.mechanism()));
    // three equations are redundant, and the driver leaves no freedom
    CHECK(rank.redundant == 3);
    CHECK(rank.redundant_rows.size() == 3);
    CHECK(rank.freedoms == rank.free_motions.cols());
    CHECK(rank.decided);
}

TEST_CASE("Velocities and accelerations satisfy the equations that they belong to", "[api]") {
    const Mechanism m = read_lesson(catalogue("loops/four-bar.toml")).mechanism();
    const Pose pose = assemble(m);
    const Rates v = velocities_at(m, pose);
    const Rates a = accelerations_at(m, pose, v);
    const Equations e = equations_at(m, pose, v, Coordinates::omega_local);
    const auto columns = [&](const Rates& rates) {
        Eigen::VectorXd q(e.jacobian.cols());
        for (std::size_t b = 1; b < rates.r_dot.size(); ++b) {
            const auto first = 6 * static_cast<Eigen::Index>(b - 1);
            q.segment<3>(first) = rates.r_dot[b];
            q.segment<3>(first + 3) = rates.omega_local[b];
        }
        return q;
    };
    // rounding of products of numbers up to 40 (omega squared), and the pose's own 1e-13
    CHECK((e.jacobian * columns(v) - e.nu).cwiseAbs().maxCoeff() < 1e-10);
    CHECK((e.jacobian * columns(a) - e.gamma).cwiseAbs().maxCoeff() < 1e-10);
}

TEST_CASE("What follows a driver has velocities that are the differences of its poses", "[api]") {
    const Mechanism m = read_lesson(catalogue("loops/four-bar.toml")).mechanism();
    const double h = 1e-4;
    const std::vector<Moment> moments = follow(m, {0.3 - h, 0.3, 0.3 + h});
    for (std::size_t b = 1; b < m.body_names().size(); ++b) {
        const Vector3 difference = (moments[2].pose.r[b] - moments[0].pose.r[b]) / (2.0 * h);
        // h² / 6 times the third derivative, below 1e3 m/s³ at one turn in some seconds
        CHECK((difference - moments[1].velocity.r_dot[b]).norm() < 1e-5);
    }
}

TEST_CASE("A simulation that is told not to go on is not reached", "[api]") {
    const Mechanism m = read_lesson(catalogue("dynamics/simple-pendulum.toml")).mechanism();
    int asked = 0;
    Simulation settings{.method = "euler", .step = 1e-4};
    settings.go_on = [&] { return ++asked < 3; };
    CHECK_THROWS_AS(simulate(m, {0.0, 100.0}, settings), NotReached);
    CHECK(asked == 3);
}

TEST_CASE("A lesson of dynamics moves by its own method and times", "[api]") {
    const Lesson lesson = read_lesson(catalogue("dynamics/governor.toml"));
    CHECK(lesson.motion_times().empty());
    const std::vector<double> times = lesson.simulation_times();
    CHECK(times.size() == 101);
    CHECK(times.front() == 0.0);
    CHECK(lesson.simulation().method != Simulation().method);  // the lesson is stiff, and sets its own method
    CHECK(simulate(lesson.mechanism(), {0.0, times.back() / 10.0}, lesson.simulation()).size() == 2);
    const Lesson without = read_lesson(catalogue("loops/four-bar.toml"));
    CHECK(without.simulation_times().empty());
    // settings that a lesson does not give keep their defaults
    CHECK(without.simulation().method == Simulation().method);
    CHECK(
        read_lesson(catalogue("dynamics/simple-pendulum.toml")).simulation().tolerance ==
        Simulation().tolerance);
    CHECK(without.motion_times().size() > 2);
}

TEST_CASE("A pendulum of the library keeps its energy and swings with the period of small swings", "[api]") {
    Mechanism m;
    const double angle = 1e-3;
    const int bob = m.add_body("bob", {std::sin(angle), 0.0, -std::cos(angle)});
    m.add_joint("pin", "revolute", 0, bob, {.at = Vector3::Zero(), .axis = Vector3::UnitY()});
    m.set_mass(bob, 2.0, 1e-3 * Matrix3::Identity());
    m.set_gravity({0.0, 0.0, -9.81});
    const double period = 2.0 * std::numbers::pi * std::sqrt((1.0 + 0.5e-3) / 9.81);
    const std::vector<Moment> moments = simulate(m, {0.0, period / 2.0, period}, {.tolerance = 1e-10});
    // the period of large swings is longer by angle²/16; at the turning points that is second order
    CHECK(moments[1].pose.r[1].x() == Approx(-std::sin(angle)).epsilon(1e-6));
    CHECK(moments[2].pose.r[1].x() == Approx(std::sin(angle)).epsilon(1e-6));
    CHECK(moments[2].energy == Approx(moments[0].energy).epsilon(1e-9));
}

}  // namespace jointwise::test
