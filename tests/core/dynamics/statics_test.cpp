#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/core/dynamics/statics.hpp"

using namespace jw;
using namespace jw::test;

TEST_CASE(
    "A pendulum rests below its hinge, and swings there as a physical pendulum does", "[core][statics]") {
    const double mass = 2.5;
    const double J = 0.3;
    const double omega = std::sqrt(mass * kG / (J + mass));
    for (const double start : {0.01, 1.0, -2.0, 3.1, -3.14159}) {
        CAPTURE(start);
        const test::SceneBuilder rods = row_of_rods({start});
        const Centroidal scene = centroidal(rods.mechanism, point_masses(rods.mechanism, mass, J));
        const RestOutcome rest = found(scene);
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        CHECK((rest.state.r[1] + Vec3::UnitZ()).norm() < 1e-12);
        CHECK(rest.motions.stability == Stability::stable);
        REQUIRE(rest.motions.modes.size() == 1);
        // K from differences: 1e-12
        CHECK(rest.motions.modes[0].s.imag() == Approx(omega).epsilon(1e-11));
        CHECK(rest.motions.modes[0].s.real() == 0.0);
    }
    const test::SceneBuilder rods = row_of_rods({2.8});
    const Centroidal scene = centroidal(rods.mechanism, point_masses(rods.mechanism, mass, J));
    const RestOutcome above = found(scene, Seek::nearest);
    REQUIRE(above.failure == RestOutcome::Failure::none);
    CHECK((above.state.r[1] - Vec3::UnitZ()).norm() < 1e-12);
    CHECK(above.motions.stability == Stability::unstable);
    CHECK(above.motions.modes.at(0).s.real() == Approx(omega).epsilon(1e-11));
}

TEST_CASE("A double pendulum has the two frequencies of the book", "[core][statics]") {
    const test::SceneBuilder rods = row_of_rods({0.9, -1.7});
    const Centroidal scene = centroidal(rods.mechanism, point_masses(rods.mechanism, 1.0, 1e-6));
    const RestOutcome rest = found(scene);
    REQUIRE(rest.failure == RestOutcome::Failure::none);
    REQUIRE(rest.motions.modes.size() == 2);
    // equal masses and lengths: ω² = (2 ∓ √2) g / l, up to the inertia of the masses themselves
    CHECK(rest.motions.modes[0].s.imag() == Approx(std::sqrt((2.0 - std::sqrt(2.0)) * kG)).epsilon(1e-5));
    CHECK(rest.motions.modes[1].s.imag() == Approx(std::sqrt((2.0 + std::sqrt(2.0)) * kG)).epsilon(1e-5));
    // the angles of both rods against the vertical, 1 : ±√2
    const auto ratio = [&](std::size_t mode) {
        const Motion& shape = rest.motions.modes[mode].shape;
        const auto turn = [&](std::size_t b) {
            return (rotation_matrix(rest.state.p[b]) * shape.omega_local[b]).y();
        };
        return turn(2) / turn(1);
    };
    CHECK(ratio(0) == Approx(std::sqrt(2.0)).epsilon(1e-5));
    CHECK(ratio(1) == Approx(-std::sqrt(2.0)).epsilon(1e-5));
}

TEST_CASE("A damped slide has the two rates of its quadratic equation", "[core][statics]") {
    for (const double damping : {0.0, 0.4, 8.0, 40.0}) {
        CAPTURE(damping);
        test::SceneBuilder builder;
        const int sled = builder.add_body("sled", Vec3(0.3, 0.2, 0.1));
        const Vec3 axis(0.6, 0.0, -0.8);
        const Joint& slide = builder.add_joint("prismatic", 0, sled, Vec3(0.3, 0.2, 0.1), axis);
        Loads loads = point_masses(builder.mechanism, 2.0, 0.1);
        const JointGeometry& g = slide.geometry;
        loads.springs.push_back({0, sled, g.P_i_local, g.P_j_local, 50.0, 0.25, damping, Vec3(g.s_i_local)});
        const RestOutcome rest = found(centroidal(builder.mechanism, loads));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        const Vec3 way = rest.state.r[1] - Vec3(0.3, 0.2, 0.1);
        CHECK((way - (0.25 + 2.0 * kG * 0.8 / 50.0) * axis).norm() < 1e-12);
        CHECK(rest.motions.stability == Stability::stable);
        CHECK(rest.motions.is_damped == (damping > 0.0));
        const double decay = damping / 4.0;
        const std::complex<double> root = std::sqrt(std::complex<double>(decay * decay - 25.0));
        const bool swings = decay < 5.0;
        REQUIRE(rest.motions.modes.size() == (swings ? 1 : 2));
        const std::complex<double> slow = -decay + root;
        CHECK(std::abs(rest.motions.modes[0].s - slow) < 1e-9);
        if (!swings) { CHECK(std::abs(rest.motions.modes[1].s - (-decay - root)) < 1e-9); }
    }
}

TEST_CASE("Ziegler's column flutters from a follower force of (7/2 - sqrt 2) k/l on", "[core][statics]") {
    // masses 2 m and m at the ends of two rods with equal rotational springs
    const double k = 3.0;
    const double critical = (3.5 - std::sqrt(2.0)) * k;
    for (const double share : {0.5, 0.99, 0.999, 1.001, 1.01, 1.3}) {
        CAPTURE(share);
        const test::SceneBuilder rods = row_of_rods({0.0, 0.0});
        Loads loads = point_masses(rods.mechanism, 1.0, 1e-9);
        loads.gravity.setZero();
        loads.masses[1]->mass = 2.0;
        for (const Joint& joint : rods.mechanism.joints) {
            loads.rotational_springs.push_back({joint.body_i, joint.body_j, angle_of(joint), k, 0.0, 0.0});
        }
        AppliedForce follower;
        follower.body = 2;
        follower.direction = rods.local(2, Vec3::UnitZ());
        follower.frame = Frame::local;
        follower.magnitude = test::polynomial({share * critical});
        loads.forces.push_back(follower);
        const RestOutcome rest = found(centroidal(rods.mechanism, loads));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        CHECK_FALSE(rest.motions.is_conservative);
        const Mode& first = rest.motions.modes.at(0);
        if (share < 1.0) {
            CHECK(rest.motions.stability == Stability::cannot_tell);
            CHECK(std::abs(first.s.real()) < 1e-6);
        } else {
            CHECK(rest.motions.stability == Stability::unstable);
            CHECK(first.s.real() > 0.01);
            CHECK(first.s.imag() > 0.1);
        }
    }
}

TEST_CASE(
    "A pendulum is the same beside bodies that are much heavier, stiffer or larger", "[core][statics]") {
    const auto omega = [](double J) { return std::sqrt(kG / (1.0 + J)); };
    for (const double mass : {1e-4, 1.0, 1e6}) {
        CAPTURE(mass);
        test::SceneBuilder rods = row_of_rods({1.5});
        const int heavy = rods.add_body("heavy", Vec3(5.0, 0.0, 0.0));
        rods.add_joint("revolute", 0, heavy, Vec3(5.0, 0.0, 1.0), Vec3::UnitX());
        const int stiff = rods.add_body("stiff", Vec3(0.0, 9.0, 0.0));
        const JointGeometry slide =
            rods.add_joint("prismatic", 0, stiff, Vec3(0.0, 9.0, 0.0), Vec3::UnitX()).geometry;
        Loads loads = point_masses(rods.mechanism, 1.0, 1e-3);
        loads.masses[at(heavy)]->mass = mass;
        loads.springs.push_back({0, stiff, slide.P_i_local, slide.P_j_local, 1e6, 0.0, 0.0, slide.s_i_local});
        const RestOutcome rest = found(centroidal(rods.mechanism, loads));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        CHECK((rest.state.r[1] + Vec3::UnitZ()).norm() < 1e-9);
        REQUIRE(rest.motions.modes.size() == 3);
        CHECK(rest.motions.stability == Stability::stable);
        std::vector<double> found;
        for (const Mode& mode : rest.motions.modes) { found.push_back(mode.s.imag()); }
        std::vector<double> expected{omega(1e-3), omega(1e-3 / mass), 1e3};
        std::ranges::sort(found);
        std::ranges::sort(expected);
        for (std::size_t k = 0; k < 3; ++k) { CHECK(found[k] == Approx(expected[k]).epsilon(1e-8)); }
    }
}

TEST_CASE("The coordinate of a gear has no inertia, whatever else the scene weighs", "[core][statics]") {
    for (const double heavy : {1.0, 1e5}) {
        CAPTURE(heavy);
        test::SceneBuilder builder;
        const int first = builder.add_body("first", Vec3::Zero());
        const int second = builder.add_body("second", Vec3(0.2, 0.0, 0.0));
        const int table = builder.add_body("table", Vec3(0.0, 3.0, 0.0));
        const Joint hinge = builder.add_joint("revolute", 0, first, Vec3::Zero(), Vec3::UnitZ());
        builder.add_joint("revolute", 0, second, Vec3(0.2, 0.0, 0.0), Vec3::UnitZ());
        builder.add_wheels(
            "gear", first, second, Vec3::Zero(), Vec3(0.2, 0.0, 0.0), Vec3::UnitZ(), Vec3::UnitZ(), -1.0);
        builder.add_joint("prismatic", 0, table, Vec3(0.0, 3.0, 0.0), Vec3::UnitX());
        Loads loads = point_masses(builder.mechanism, 1.0, 1e-6);
        loads.masses[at(table)]->mass = heavy;
        loads.rotational_springs.push_back({0, first, angle_of(hinge), 1e-3, 0.0, 0.0});
        const RestOutcome rest = found(centroidal(builder.mechanism, loads));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        REQUIRE(rest.motions.modes.size() == 2);
        CHECK(rest.motions.modes[0].s == 0.0);
        CHECK(rest.motions.modes[1].s.imag() == Approx(std::sqrt(1e-3 / 2e-6)).epsilon(1e-8));
    }
}

TEST_CASE("A short spring far from the origin is as stiff as any", "[core][statics]") {
    for (const double extent : {1.0, 1000.0}) {
        CAPTURE(extent);
        test::SceneBuilder builder;
        const Vec3 place(extent, 0.0, 0.0);
        const int sled = builder.add_body("sled", place);
        const Joint& slide = builder.add_joint("prismatic", 0, sled, place, Vec3::UnitX());
        Loads loads = point_masses(builder.mechanism, 1.0, 0.1);
        // across the rail: k (1 - free / length) = 50 of 100 N/m
        loads.springs.push_back(
            {0, sled, builder.local_point(0, place + 0.1 * Vec3::UnitY()), slide.geometry.P_j_local, 100.0,
             0.05, 0.0});
        const RestOutcome rest = found(centroidal(builder.mechanism, loads));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        CHECK(rest.motions.modes.at(0).s.imag() == Approx(std::sqrt(50.0)).epsilon(1e-7));
    }
}

TEST_CASE("From beside an unstable equilibrium a pendulum falls, however near it starts", "[core][statics]") {
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-10}) {
        CAPTURE(off);
        const test::SceneBuilder rods = row_of_rods({std::numbers::pi - off});
        const RestOutcome rest = found(centroidal(rods.mechanism, point_masses(rods.mechanism, 1.0, 0.1)));
        REQUIRE(rest.failure == RestOutcome::Failure::none);
        CHECK(rest.motions.stability == Stability::stable);
        CHECK((rest.state.r[1] + Vec3::UnitZ()).norm() < 1e-9);
    }
}

TEST_CASE(
    "A column held by a spring buckles as its closed form says, near its load, too", "[core][statics]") {
    const double load = kG;  // 1 kg at 1 m
    for (const double margin : {1e-2, 1e-4, 1e-6, 1e-8}) {
        CAPTURE(margin);
        test::SceneBuilder rods = row_of_rods({std::numbers::pi - 0.3});
        Joint& hinge = rods.mechanism.joints[0];
        const double up = relative_angle(hinge, start_state(rods.mechanism)) - 0.3;
        for (const double sign : {1.0, -1.0}) {
            Loads loads = point_masses(rods.mechanism, 1.0, 1e-9);
            const double k = load * (1.0 + sign * margin);
            loads.rotational_springs.push_back({0, 1, angle_of(hinge), k, up, 0.0});
            const RestOutcome rest = found(centroidal(rods.mechanism, loads));
            REQUIRE(rest.failure == RestOutcome::Failure::none);
            CHECK(rest.motions.stability == Stability::stable);
            // k θ = m g l sin θ, by bisection
            double theta = 0.0;
            if (sign < 0.0) {
                double low = std::sqrt(margin);
                double high = 3.0;
                for (int step = 0; step < 200; ++step) {
                    theta = 0.5 * (low + high);
                    // θ - sin θ by its series where the difference would lose its digits
                    const double rest_of_sine =
                        theta < 0.1 ? theta * theta * theta / 6.0 * (1.0 - theta * theta / 20.0)
                                    : theta - std::sin(theta);
                    (rest_of_sine < margin * theta ? low : high) = theta;
                }
            }
            const double found_theta = std::asin(rest.state.r[1].x());
            // rounding of the torque, divided by the stiffness that is left
            CHECK(std::abs(std::abs(found_theta) - theta) < 1e-4 * std::sqrt(margin) + 1e-15 / margin);
            const double omega = std::sqrt(std::max(k - load * std::cos(theta), 0.0));
            CHECK(rest.motions.modes.at(0).s.imag() == Approx(omega).epsilon(1e-3));
        }
    }
}

TEST_CASE("At a singular pose there is no verdict, and there are no modes", "[core][statics]") {
    // crank and rod of the same length, folded over each other below the crank's bearing
    const Mechanism mechanism = test::slider_crank(1.0, 1.0, 0.5 * std::numbers::pi);
    Loads loads = point_masses(mechanism, 1.0, 0.1);
    loads.gravity = Vec3(0.0, kG, 0.0);
    const RestOutcome rest = found(centroidal(mechanism, loads));
    REQUIRE(rest.failure == RestOutcome::Failure::none);
    CHECK(rest.motions.is_singular);
    CHECK(rest.motions.stability == Stability::cannot_tell);
    CHECK(rest.motions.modes.empty());
}

TEST_CASE("Turns of a wound spring are counted on the way to its rest", "[core][statics]") {
    test::SceneBuilder builder;
    const int wheel = builder.add_body("wheel", Vec3(0.0, 1.0, 0.0));
    const Joint hinge = builder.add_joint("revolute", 0, wheel, Vec3(0.0, 1.0, 0.0), Vec3::UnitX());
    Loads loads = point_masses(builder.mechanism, 1.0, 0.1);
    loads.rotational_springs.push_back({0, wheel, angle_of(hinge), 2.0, 20.0 * std::numbers::pi + 0.5, 0.0});
    const RestOutcome rest = found(centroidal(builder.mechanism, loads));
    REQUIRE(rest.failure == RestOutcome::Failure::none);
    CHECK(rest.turns == std::vector<int>{10});
    CHECK(relative_angle(hinge, rest.state) == Approx(0.5));
}

TEST_CASE("Where nothing stops a body, the search says how it is still pushed", "[core][statics]") {
    test::SceneBuilder builder;
    const int stone = builder.add_body("stone", Vec3::Zero());
    const Vec3 axis = Vec3(1.0, 0.0, -1.0).normalized();
    builder.add_joint("prismatic", 0, stone, Vec3::Zero(), axis);
    const RestOutcome rest = found(centroidal(builder.mechanism, point_masses(builder.mechanism, 1.0, 1.0)));
    CHECK(rest.failure == RestOutcome::Failure::endless);
    CHECK((rest.acceleration.r_dot[1] - kG * std::sqrt(0.5) * axis).norm() < 1e-9);
}

TEST_CASE("A freedom that nothing holds or pushes has no verdict", "[core][statics]") {
    test::SceneBuilder builder;
    const int wheel = builder.add_body("wheel", Vec3(0.0, 1.0, 0.0));
    builder.add_joint("revolute", 0, wheel, Vec3(0.0, 1.0, 0.0), Vec3::UnitX());
    const RestOutcome rest = found(centroidal(builder.mechanism, point_masses(builder.mechanism, 1.0, 1.0)));
    REQUIRE(rest.failure == RestOutcome::Failure::none);
    CHECK(rest.motions.stability == Stability::cannot_tell);
    CHECK(rest.motions.modes.at(0).s == 0.0);
}

TEST_CASE(
    "A controlled pendulum rests where its torques balance, and its modes include the law",
    "[core][statics]") {
    constexpr double k = 40.0;
    constexpr double inertia = 1.1;
    double angle = 0.3;
    for (int n = 0; n < 20; ++n) {
        angle -= (kG * std::sin(angle) + k * (angle - 0.3)) / (kG * std::cos(angle) + k);
    }
    const double stiffness = k + kG * std::cos(angle);
    for (const double c : {3.0, -3.0}) {
        const Mechanism mechanism = row_of_rods({0.0}).mechanism;
        Loads loads = point_masses(mechanism, 1.0, inertia - 1.0);
        loads.torques.push_back({1, Vec3::UnitY(), Frame::global, {}});
        using Kind = FormulaStep::Kind;
        RotationalSpring read{0, 1, angle_of(mechanism.joints[0])};
        read.is_read = true;
        // k (0.3 - θ) - c θ̇
        loads.torques[0].law = LoadLaw{
            {"controller",
             {{Kind::number, k},
              {Kind::number, 0.3},
              {Kind::variable, 1.0},
              {Kind::difference},
              {Kind::product},
              {Kind::number, c},
              {Kind::variable, 2.0},
              {Kind::product},
              {Kind::difference}}},
            {{"hinge.angle", read}}};
        const RestOutcome outcome = found(centroidal(mechanism, loads));
        REQUIRE(outcome.failure == RestOutcome::Failure::none);
        CHECK(std::abs(relative_angle(mechanism.joints[0], outcome.state) - angle) < 1e-10);
        CHECK(outcome.motions.stability == (c > 0.0 ? Stability::stable : Stability::unstable));
        const std::complex<double> s = outcome.motions.modes.front().s;
        CHECK(s.real() == Approx(-c / (2.0 * inertia)).epsilon(1e-8));
        CHECK(std::norm(s) == Approx(stiffness / inertia).epsilon(1e-8));
        loads.torques[0].law->formula = {"kink", {{Kind::variable, 2.0}, {Kind::absolute}}};
        CHECK(found(centroidal(mechanism, loads)).motions.at_kink);
    }
}
