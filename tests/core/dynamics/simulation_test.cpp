#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "core/integrate/simulation.hpp"
#include "core/kinematics/kinematics.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

/// A parallelogram whose last axis is tilted in one of its bodies [rad].
Mechanism tilted_four_bar(double tilt) {
    Mechanism mechanism = test::four_bar_at(0.9);
    Vec3& axis = mechanism.joints.back().geometry.s_j_local;
    axis = rotation_matrix(euler_parameters_of(perpendicular_to(axis), tilt)) * axis;
    return mechanism;
}

Loads loads_of(const Mechanism& mechanism) {
    test::Random random(3);
    return test::random_conservative_loads(random, mechanism);
}

SimulationOutcome outcome_of(const Mechanism& mechanism, int& received) {
    Simulation simulation(mechanism, loads_of(mechanism), {});
    return simulation.run({0.0, 0.05}, [&](double, const std::vector<double>&) { ++received; });
}

Loads masses_of(test::Random& random, const Mechanism& mechanism) {
    Loads loads;
    loads.masses = test::random_masses(random, mechanism);
    return loads;
}

/// Snapshot at the start of a simulation.
Snapshot start_of(const Mechanism& mechanism, const Loads& loads) {
    Simulation simulation(mechanism, loads, {});
    Snapshot start;
    const SimulationOutcome outcome = simulation.run(
        {0.0}, [&](double, const std::vector<double>& y) { start = simulation.snapshot(0.0, y); });
    REQUIRE_FALSE(outcome.failure);
    return start;
}

}  // namespace

TEST_CASE("A loop with a tilted axis is refused at the start, and the joint is named", "[core][dynamics]") {
    for (const double tilt : {0.1, 1e-4}) {
        const Mechanism mechanism = tilted_four_bar(tilt);
        int received = 0;
        const SimulationOutcome outcome = outcome_of(mechanism, received);
        REQUIRE(outcome.failure);
        CHECK(outcome.failure->cause == SimulationFailure::Cause::contradiction);
        CHECK(received == 0);
        const auto names_it = [&](const Joint& joint) { return joint.name == outcome.failure->equation_of; };
        CHECK(std::ranges::any_of(mechanism.joints, names_it));
        // the part of the tilt that the loop leaves to one equation
        CHECK(outcome.failure->violation > 0.1 * tilt);
        CHECK(outcome.failure->violation < 2.0 * tilt);
    }
}

TEST_CASE("A loop that closes to its typed digits only is no contradiction", "[core][dynamics]") {
    int received = 0;
    CHECK_FALSE(outcome_of(tilted_four_bar(1e-7), received).failure);
    CHECK(received == 2);
}

TEST_CASE(
    "A step of explicit-5 evaluates the equations six times, its last stage being the next one's first",
    "[core][dynamics]") {
    const Mechanism mechanism = tilted_four_bar(0.0);
    SimulationSettings settings;
    settings.method = Method::explicit_5;
    // loose, so that steps drift by more than allowed, and are projected and evaluated again
    for (const double tolerance : {1e-9, 1e-3}) {
        settings.tolerance = tolerance;
        Simulation simulation(mechanism, loads_of(mechanism), settings);
        const SimulationOutcome outcome =
            simulation.run({0.0, 1.0}, [](double, const std::vector<double>&) {});
        REQUIRE_FALSE(outcome.failure);
        const IntegrationCounts& counts = outcome.counts;
        CAPTURE(tolerance, counts.steps, counts.rejected, counts.projections, counts.row_choices);
        const long attempts = counts.steps + counts.rejected;
        // one at the start, which is a projection, too
        CHECK(counts.evaluations >= 1 + 6 * attempts);
        CHECK(counts.evaluations <= 1 + 6 * attempts + counts.projections + counts.row_choices);
        CHECK(counts.projections < attempts);
    }
}

TEST_CASE("Implicit methods move bodies whose joints have no coordinates", "[core][dynamics]") {
    // a straight chain with p = (1, 0, 0, 0): e0 and all x have extreme values and determine nothing
    test::SceneBuilder chain;
    for (int k = 0; k < 2; ++k) {
        const int rod = chain.add_body("rod", Vec3(0.5 + k, 0.0, 0.0));
        chain.mechanism.bodies.back().p = Vec4::Unit(0);
        chain.add_joint("spherical", k == 0 ? 0 : rod - 1, rod, Vec3(k, 0.0, 0.0), Vec3::UnitZ());
    }
    test::SceneBuilder free;
    free.mechanism.bodies.front().fixed = true;
    free.add_body("free", Vec3(2.0, 0.0, 0.0));
    free.mechanism.bodies.back().omega_local = Vec3(1.0, 6.0, 2.0);
    for (const Mechanism& mechanism : {chain.mechanism, free.mechanism}) {
        Loads loads;
        loads.gravity = Vec3(0.0, -9.81, 0.0);
        loads.masses.assign(mechanism.bodies.size(), MassProperties{});
        for (auto& mass : loads.masses) { mass->J_local = Vec3(0.1, 0.2, 0.25).asDiagonal(); }
        const auto samples = [&](Method method, double tolerance) {
            SimulationSettings settings;
            settings.method = method;
            settings.tolerance = tolerance;
            Simulation simulation(mechanism, loads, settings);
            std::vector<double> all;
            const SimulationOutcome outcome = simulation.run(
                {0.0, 0.25, 0.5, 0.75, 1.0},
                [&](double, const std::vector<double>& y) { all.insert(all.end(), y.begin(), y.end()); });
            CHECK_FALSE(outcome.failure);
            return all;
        };
        const std::vector<double> expected = samples(Method::explicit_8, 1e-12);
        for (const Method method : {Method::implicit_5, Method::implicit_9}) {
            const std::vector<double> found = samples(method, 1e-8);
            REQUIRE(found.size() == expected.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                CAPTURE(k);
                // a hundred steps of 1e-8 by velocities up to 10
                CHECK(std::abs(found[k] - expected[k]) < 1e-5);
            }
        }
    }
}

TEST_CASE(
    "The angle of a disc is followed through steps of many turns, and at times between", "[core][dynamics]") {
    test::SceneBuilder scene;
    const int disc = scene.add_body("disc", Vec3::Zero());
    scene.add_joint("revolute", 0, disc, Vec3::Zero(), Vec3::UnitZ());
    Loads loads;
    loads.masses = {std::nullopt, MassProperties{1.0, Vec3::Zero(), 0.01 * Mat3::Identity()}};
    AppliedTorque torque;
    torque.body = disc;
    torque.magnitude = test::polynomial({0.0, 6.0});
    loads.torques.push_back(torque);
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        SimulationSettings settings;
        settings.formulation = formulation;
        settings.tolerance = 1e-9;
        Simulation simulation(scene.mechanism, loads, settings);
        simulation.follow_angles();
        const SimulationOutcome outcome =
            simulation.run({0.0, 0.7, 2.0, 2.9, 3.0}, [&](double t, const std::vector<double>& y) {
                const Snapshot now = simulation.snapshot(t, y);
                const double angle =
                    relative_angle(scene.mechanism.joints[0], now.state) + 2.0 * test::kPi * now.turns[0];
                CAPTURE(formulation, t);
                // θ̈ = 600 t; hundreds of steps of 1e-9 of 2700 rad
                CHECK(std::abs(angle - 100.0 * t * t * t) < 1e-3);
            });
        REQUIRE_FALSE(outcome.failure);
        // in coordinates of the joint, steps are longer than turns
        if (formulation == Formulation::joints) { CHECK(outcome.counts.steps < 100); }
    }
}

TEST_CASE("Fixed steps end where a rotational spring turns too far in one", "[core][dynamics]") {
    test::SceneBuilder scene;
    const int disc = scene.add_body("disc", Vec3::Zero());
    scene.add_joint("revolute", 0, disc, Vec3::Zero(), Vec3::UnitZ());
    scene.mechanism.bodies[1].omega_local = scene.local(disc, 300.0 * Vec3::UnitZ());
    Loads loads;
    loads.masses = {std::nullopt, MassProperties{1.0, Vec3::Zero(), Vec3(0.5, 0.5, 0.01).asDiagonal()}};
    loads.rotational_springs.push_back({0, disc, angle_of(scene.mechanism.joints[0]), 0.5, 0.0, 0.0});
    SimulationSettings settings;
    for (const Method method : {Method::rk4, Method::semi_implicit}) {
        settings.method = method;
        // 300 rad/s: 34 and 103 degrees in a step
        for (const double step : {0.002, 0.006}) {
            CAPTURE(static_cast<int>(method), step);
            settings.step = step;
            Simulation simulation(scene.mechanism, loads, settings);
            const SimulationOutcome outcome =
                simulation.run({0.0, 0.5}, [](double, const std::vector<double>&) {});
            REQUIRE(outcome.failure.has_value() == (step > 0.005));
            if (!outcome.failure) { continue; }
            CHECK(outcome.failure->cause == SimulationFailure::Cause::turns_lost);
            CHECK(outcome.failure->equation_of == scene.mechanism.joints[0].name);
            CHECK(outcome.failure->turn == Approx(300.0 * step));
        }
    }
}

TEST_CASE(
    "A start velocity that is given for one body of a loop is kept, and the others follow",
    "[core][dynamics]") {
    Mechanism mechanism = test::four_bar_at(0.9);
    const auto turning = [&](int body, double rate) {
        const Vec4& p = mechanism.bodies[static_cast<std::size_t>(body)].p;
        return Vec3(rotation_matrix(p).transpose() * (rate * Vec3::UnitZ()));
    };
    const auto started = [&] {
        test::Random random(5);
        const Snapshot start = start_of(mechanism, masses_of(random, mechanism));
        CHECK(start.velocity_violation < 1e-13);
        return start.velocity;
    };
    // the crank, whose origin lies on its axis, and the coupler, whose origin does not
    for (const int body : {1, 2}) {
        CAPTURE(body);
        const auto b = static_cast<std::size_t>(body);
        mechanism.bodies[b].omega_local = turning(body, 5.0);
        CHECK((started().omega_local[b] - mechanism.bodies[b].omega_local).norm() < 1e-12);
        mechanism.bodies[b].omega_local.setZero();
    }
    // two velocities that no motion has: the nearest possible ones are used, and neither is as given
    mechanism.bodies[1].omega_local = turning(1, 5.0);
    mechanism.bodies[3].omega_local = turning(3, -5.0);
    const Motion nearest = started();
    CHECK((nearest.omega_local[1] - mechanism.bodies[1].omega_local).norm() > 1.0);
    CHECK((nearest.omega_local[3] - mechanism.bodies[3].omega_local).norm() > 1.0);
}

TEST_CASE(
    "A start rate that is given for a joint of a loop is kept, and the bodies follow", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        test::Random random(seed);
        Mechanism mechanism = test::four_bar_at(random.number(0.3, 2.5));
        const auto k = static_cast<std::size_t>(seed % 4);
        const double rate = random.number(-5.0, 5.0);
        mechanism.joints[k].geometry.angle_dot_start = rate;
        const Loads loads = masses_of(random, mechanism);
        const auto started = [&] {
            const Snapshot start = start_of(mechanism, loads);
            CHECK(start.velocity_violation < 1e-12);
            return start;
        };
        CAPTURE(seed, mechanism.joints[k].name, rate);
        const Snapshot start = started();
        const double found = angle_rate(mechanism.joints[k], start.state, start.velocity);
        CHECK(std::abs(found - rate) < 1e-10 * (1.0 + std::abs(rate)));
        // the same motion as that of a driver with this rate
        Mechanism driven = mechanism;
        const double angle = relative_angle(mechanism.joints[k], start.state);
        const auto joint = static_cast<int>(k);
        driven.drivers.push_back(
            {"motor", joint, driven.joints[k].body_i, driven.joints[k].body_j, angle_of(driven.joints[k]),
             TimeFunction{.polynomial = {angle, rate}}});
        driven.joints[k].geometry.angle_dot_start = {};
        System system(driven, everything(driven));
        system.choose_rows(start.state);
        Kinematics<OmegaLocal> kinematics(system);
        kinematics.set_state(start.state, 0.0);
        const Motion motion = kinematics.solve_velocity(zero_motion(driven)).velocity;
        for (std::size_t b = 1; b < 4; ++b) {
            CHECK((motion.omega_local[b] - start.velocity.omega_local[b]).norm() < 1e-8);
        }
        // two rates that no motion has: neither is kept
        mechanism.joints[(k + 1) % 4].geometry.angle_dot_start = found * 100.0 + 1.0;
        const Snapshot nearest = started();
        CHECK(std::abs(angle_rate(mechanism.joints[k], nearest.state, nearest.velocity) - rate) > 1e-3);
    }
}

TEST_CASE(
    "A start rate that a singular pose does not allow moves nothing else, and one beside it is kept",
    "[core][dynamics]") {
    // a slider-crank at its dead centre: the slider has no velocity there, whatever the crank does
    test::SceneBuilder scene;
    const int crank = scene.add_body("crank", Vec3(0.1, 0.0, 0.0));
    const int rod = scene.add_body("rod", Vec3(0.45, 0.0, 0.0));
    const int slider = scene.add_body("slider", Vec3(0.7, 0.0, 0.0));
    scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ());
    scene.add_joint("revolute", crank, rod, Vec3(0.2, 0.0, 0.0), Vec3::UnitZ());
    scene.add_joint("revolute", rod, slider, Vec3(0.7, 0.0, 0.0), Vec3::UnitZ());
    scene.add_joint("prismatic", 0, slider, Vec3(0.7, 0.0, 0.0), Vec3::UnitX());
    test::Random random(3);
    const Loads loads = masses_of(random, scene.mechanism);
    std::vector<Joint>& joints = scene.mechanism.joints;
    const auto crank_rate = [&] {
        const Snapshot start = start_of(scene.mechanism, loads);
        return angle_rate(joints[0], start.state, start.velocity);
    };
    joints[3].geometry.displacement_dot_start = 0.5;
    CHECK(std::abs(crank_rate()) < 1e-10);
    joints[0].geometry.angle_dot_start = 5.0;
    CHECK(crank_rate() == Approx(5.0));
}

TEST_CASE("A slow start rate beside a fast body is kept", "[core][dynamics]") {
    test::SceneBuilder scene;
    test::Random random(4);
    const int rotor = scene.add_body("rotor", random.vector());
    const int sled = scene.add_body("sled", random.vector());
    scene.add_joint("spherical", 0, rotor, random.vector(), Vec3::UnitZ());
    scene.add_joint("prismatic", 0, sled, random.vector(), random.direction());
    scene.mechanism.bodies[static_cast<std::size_t>(rotor)].omega_local = Vec3(0.0, 1000.0, 0.0);
    scene.mechanism.joints[1].geometry.displacement_dot_start = 0.05;
    const Motion start = start_of(scene.mechanism, masses_of(random, scene.mechanism)).velocity;
    CHECK(start.r_dot[static_cast<std::size_t>(sled)].norm() == Approx(0.05));
    CHECK(start.omega_local[static_cast<std::size_t>(rotor)].norm() == Approx(1000.0));
}

TEST_CASE(
    "Start rates that contradict each other become the nearest ones, and others are kept",
    "[core][dynamics]") {
    test::SceneBuilder scene;
    test::Random random(5);
    const int nut = scene.add_body("nut", random.vector());
    const int arm = scene.add_body("arm", random.vector());
    Joint& screw = scene.add_joint("screw", 0, nut, random.vector(), random.direction());
    screw.geometry.alpha = 0.1;
    screw.geometry.displacement_dot_start = 2.0;
    screw.geometry.angle_dot_start = 25.0;
    scene.add_joint("revolute", 0, arm, random.vector(), random.direction()).geometry.angle_dot_start = 7.0;
    const Snapshot start = start_of(scene.mechanism, masses_of(random, scene.mechanism));
    const double turning = angle_rate(scene.mechanism.joints[0], start.state, start.velocity);
    // between the two, 2 / 0.1 = 20 and 25 rad/s
    CHECK(turning > 20.0);
    CHECK(turning < 25.0);
    CHECK(angle_rate(scene.mechanism.joints[1], start.state, start.velocity) == Approx(7.0));
}

TEST_CASE(
    "Start rates of both freedoms of a cylindrical joint are those that dynamics begins with",
    "[core][dynamics]") {
    test::SceneBuilder scene;
    test::Random random(3);
    const int body = scene.add_body("slider", random.vector());
    Joint& cylinder = scene.add_joint("cylindrical", 0, body, random.vector(), random.direction());
    cylinder.geometry.angle_dot_start = 2.0;
    cylinder.geometry.displacement_dot_start = -0.7;
    const Snapshot start = start_of(scene.mechanism, masses_of(random, scene.mechanism));
    const Joint given = scene.mechanism.joints.front();
    CHECK(angle_rate(given, start.state, start.velocity) == Approx(2.0));
    const Measured d = evaluate_measure(
        displacement_of(given), given.body_i, given.body_j, -1, start.state, start.velocity,
        zero_motion(scene.mechanism));
    CHECK(d.rate == Approx(-0.7));
}
