#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jointwise/lesson.hpp"
#include "jointwise/measures.hpp"

namespace jointwise::test {
namespace {

using Catch::Contains;

constexpr double kGravity = 9.81;

/// A bob of 2 kg on a rod of 1 m about y, swinging from level.
Mechanism swinging_rod() {
    Mechanism m;
    m.add_body("bob", {1.0, 0.0, 0.0});
    m.add_joint("pin", "revolute", 0, 1, {.at = Vector3::Zero(), .axis = Vector3::UnitY()});
    m.set_mass(1, 2.0, 1e-3 * Matrix3::Identity());
    m.set_gravity({0.0, 0.0, -kGravity});
    return m;
}

}  // namespace

TEST_CASE("Quantities of the library are the numbers of the moment that they are about", "[api]") {
    const Mechanism m = read_lesson(JW_SOURCE_ROOT "/lessons/catalogue/loops/four-bar.toml").mechanism();
    const Trajectory motion = follow_trajectory(m, {0.0, 0.1, 0.2});
    const std::string body = m.body_names()[1];
    const Quantities quantities(
        m, {body + ".x", body + ".r_dot.y", body + ".omega_local.z", body + ".r_ddot.x"});
    CHECK(quantities.units() == std::vector<std::string>{"m", "m/s", "rad/s", "m/s²"});
    const Table table = quantities.along(motion);
    REQUIRE(table.rows() == 3);
    for (int k = 0; k < 3; ++k) {
        const Moment moment = motion.moment(k);
        CHECK(table(k, 0) == moment.pose.r[1].x());
        CHECK(table(k, 1) == moment.velocity.r_dot[1].y());
        CHECK(table(k, 2) == moment.velocity.omega_local[1].z());
        CHECK(table(k, 3) == moment.acceleration.r_dot[1].x());
        CHECK(table.row(k).transpose() == quantities.at(moment));
    }
}

TEST_CASE("Every name that a mechanism lists is read, and has values in the end", "[api]") {
    const Mechanism m = swinging_rod();
    const std::vector<std::string> names = quantity_names(m);
    CHECK(std::ranges::find(names, "pin.angle_dot") != names.end());
    CHECK(std::ranges::find(names, "energy.sum") != names.end());
    const Quantities quantities(m, names);
    CHECK(quantities.names() == names);
    const Table table = quantities.along(simulate_trajectory(m, {0.1, 0.2}));
    // only rates of sizes that stay 0, and of the ground, have no value
    CHECK(table.array().isNaN().count() * 4 < table.size());
}

TEST_CASE("Unknown names are reported", "[api]") {
    const Mechanism m = swinging_rod();
    CHECK_THROWS_WITH(Quantities(m, {"bob.y", "bobb.x"}), Contains("no quantity 'bobb.x'"));
    CHECK_THROWS_WITH(Quantities(m, {"bob.point.x"}), Contains("leaves its point open"));
}

TEST_CASE("The pin of a pendulum carries weight and centripetal force", "[api]") {
    const Mechanism m = swinging_rod();
    for (const Moment& moment : simulate(m, {0.2, 0.4, 0.6}, {.tolerance = 1e-10})) {
        const Reactions found = reactions_at(m, moment);
        REQUIRE(found.reactions.size() == 1);
        const Reaction& pin = found.reactions.front();
        CHECK(pin.name == "pin");
        CHECK_FALSE(pin.of_driver);
        CHECK(found.open == 0);
        CHECK(found.residual <= found.bound);
        // the part of weight and acceleration along the rod: m (g sin φ + ω² l), with φ below level
        const Vector3 out = moment.pose.r[1].normalized();
        const double omega = moment.velocity.omega_local[1].y();
        CHECK(-pin.force.dot(out) == Approx(2.0 * (-kGravity * out.z() + omega * omega)).epsilon(1e-8));
        CHECK(std::abs(pin.torque.y()) < 1e-9);  // it turns freely about y
        const Eigen::VectorXd values = Quantities(m, {"pin.force.x", "energy.sum"}).at(moment);
        CHECK(values(0) == Approx(pin.force.x()).epsilon(1e-12));
        CHECK(values(1) == Approx(moment.energy).margin(1e-9));
    }
}

TEST_CASE("A motor's effort times its rate is the power that the energies show", "[api]") {
    Mechanism m = swinging_rod();
    m.add_driver("motor", 0, {0.3, 2.0, 1.5});
    const Trajectory motion = simulate_trajectory(m, {0.0, 0.25, 0.5});
    const Table table = Quantities(m, {"motor.effort", "pin.angle_dot", "energy.sum_dot"}).along(motion);
    for (int k = 0; k < 3; ++k) { CHECK(table(k, 0) * table(k, 1) == Approx(table(k, 2)).epsilon(1e-8)); }
}

TEST_CASE("Reactions of bodies without masses are refused", "[api]") {
    Mechanism m;
    m.add_body("rod", {1.0, 0.0, 0.0});
    m.add_joint("pin", "revolute", 0, 1, {});
    m.add_driver("motor", 0, {0.0, 1.0});
    const Moment moment = follow(m, {0.1}).front();
    CHECK_THROWS_AS(reactions_at(m, moment), std::invalid_argument);
    CHECK(std::isnan(Quantities(m, {"energy.sum"}).at(moment)(0)));
}

}  // namespace jointwise::test
