#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "core/jets/body_kinematics.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

TEST_CASE("Forces of gravity and springs are the slope of the potential energy", "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        const Mechanism mechanism = test::random_tree(random);
        Loads loads = test::random_conservative_loads(random, mechanism);
        loads.bushings.at(0).rotational_stiffness = Vec3(1.0, 4.0, 2.5);
        const Centroidal scene = centroidal(mechanism, loads);
        REQUIRE(scene.loads.rotational_springs.size() == 1);
        const test::Moment moment = test::random_moment(random, scene, 0.0);
        const std::vector<BodyForce> forces = test::forces_of(scene.loads, moment);
        // central differences: h² times third derivatives of up to 1e2, and rounding of 1e2 J over h
        const double h = 1e-5;
        const double tolerance = 1e-7;
        for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
            for (int k = 0; k < 6; ++k) {
                const auto energy = [&](double step) {
                    test::Moment moved = moment;
                    if (k < 3) { moved.state.r[b](k) += step; }
                    if (k >= 3) {
                        moved.state.p[b] = turned_local(moved.state.p[b], step * Vec3::Unit(k - 3));
                    }
                    return potential_energy(scene.loads, test::bodies_of(moved));
                };
                const double slope = (energy(h) - energy(-h)) / (2.0 * h);
                CAPTURE(seed, b, k);
                CHECK(std::abs((k < 3 ? forces[b].f(k) : forces[b].n_local(k - 3)) + slope) < tolerance);
            }
        }
    }
}

TEST_CASE(
    "A damper takes c times the square of the rate, and pushes both bodies alike",
    "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const test::Pair pair = test::random_pair(seed);
        test::Random random(seed);
        const Vec3 P_i = random.vector();
        const Vec3 P_j = random.vector();
        Loads loads = test::without_loads(pair.mechanism, seed);
        loads.springs.push_back({0, 1, P_i, P_j, 0.0, 0.0, 1.7});
        const bool has_axis = seed % 2 == 0;
        const Vec3 s_i = random.direction();
        if (has_axis) { loads.springs.back().s_i_local = s_i; }
        const auto bodies = test::bodies_of(pair.moment);
        const std::vector<BodyForce> forces = test::forces_of(loads, pair.moment);
        double power = 0.0;
        Vec3 total = Vec3::Zero();
        Vec3 torque = Vec3::Zero();
        for (std::size_t b = 0; b < 2; ++b) {
            power +=
                forces[b].f.dot(bodies[b].r_dot) + forces[b].n_local.dot(pair.moment.motion.omega_local[b]);
            total += forces[b].f;
            torque += bodies[b].r.cross(forces[b].f) + bodies[b].A * forces[b].n_local;
        }
        const auto length = [&](double t) {
            const auto turned = [&](std::size_t b, const Vec3& s) -> Vec3 {
                return rotation_matrix(turned_local(bodies[b].p, t * pair.moment.motion.omega_local[b])) * s;
            };
            const auto end = [&](std::size_t b, const Vec3& P) -> Vec3 {
                return bodies[b].r + t * bodies[b].r_dot + turned(b, P);
            };
            const Vec3 d = end(1, P_j) - end(0, P_i);
            return has_axis ? turned(0, s_i).dot(d) : d.norm();
        };
        const double h = 1e-5;  // h² and 1e-16 / h are below 1e-9
        const double rate = (length(h) - length(-h)) / (2.0 * h);
        CHECK(std::abs(power + 1.7 * rate * rate) < 1e-8);
        CHECK(total.norm() < 1e-14);   // rounding
        CHECK(torque.norm() < 1e-13);  // rounding
    }
}

TEST_CASE(
    "Forces and torques act at their point, in the frame and at the time they are given in",
    "[core][dynamics][forces]") {
    const test::Pair pair = test::random_pair(4);
    const auto bodies = test::bodies_of(pair.moment);
    const Mat3& A = bodies[1].A;
    const Vec3 point(0.1, -0.4, 0.3);
    const Vec3 direction(1.0, 2.0, -2.0);
    TimeFunction grows;
    grows.polynomial = {1.0, 3.0};
    const double size = 1.0 + 3.0 * 0.5;
    for (const Frame frame : {Frame::global, Frame::local}) {
        Loads loads = test::without_loads(pair.mechanism, 4);
        loads.forces.push_back({1, point, direction, frame, grows});
        loads.torques.push_back({1, direction, frame, grows});
        const std::vector<BodyForce> forces = test::forces_of(loads, pair.moment, 0.5);
        const Vec3 f = size * (frame == Frame::local ? (A * direction).eval() : direction);
        const Vec3 n = (A * point).cross(f) + f;  // the torque has the components of the force
        CHECK((forces[1].f - f).norm() < 1e-14);
        CHECK((A * forces[1].n_local - n).norm() < 1e-14);
        CHECK(forces[0].f.norm() + forces[0].n_local.norm() == 0.0);
    }
}

TEST_CASE("A torque against another body acts on it in the opposite direction", "[core][dynamics][forces]") {
    const test::Pair pair = test::random_pair(6);
    const auto bodies = test::bodies_of(pair.moment);
    const Vec3 direction(1.0, 2.0, -2.0);
    for (const Frame frame : {Frame::global, Frame::local}) {
        Loads loads = test::without_loads(pair.mechanism, 6);
        loads.torques.push_back({1, direction, frame, TimeFunction{.polynomial = {3.0}}, 0});
        const std::vector<BodyForce> forces = test::forces_of(loads, pair.moment);
        const Vec3 n = 3.0 * (frame == Frame::local ? (bodies[1].A * direction).eval() : direction);
        CHECK((bodies[1].A * forces[1].n_local - n).norm() < 1e-14);
        CHECK((bodies[0].A * forces[0].n_local + n).norm() < 1e-14);
        CHECK(forces[0].f.norm() + forces[1].f.norm() == 0.0);
    }
}

namespace {

/// f = 5 x² - 7 + 3 ẋ
ScalarFormula law_of_test() {
    using Kind = FormulaStep::Kind;
    return {
        "",
        {{Kind::number, 5.0},
         {Kind::variable, 0.0},
         {Kind::power, 2.0},
         {Kind::product},
         {Kind::number, 7.0},
         {Kind::difference},
         {Kind::number, 3.0},
         {Kind::variable, 1.0},
         {Kind::product},
         {Kind::sum}}};
}

constexpr DryFriction kFriction{1.5, 0.2};

/// A body at x = 2 m on a spring from the ground, and turned by 0.4 rad about z.
struct Sprung {
    Spring spring{0, 1, Vec3::Zero(), Vec3::Zero()};
    RotationalSpring turned{0, 1, {Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitX()}};
    std::vector<BodyKinematics<OmegaLocal>> bodies;

    Sprung() {
        const Vec4 p(std::cos(0.2), 0.0, 0.0, std::sin(0.2));
        bodies.push_back(kinematics_at<OmegaLocal>(Vec3::Zero(), Vec4::Unit(0), Vec3::Zero(), Vec3::Zero()));
        bodies.push_back(
            kinematics_at<OmegaLocal>(Vec3(2.0, 0.0, 0.0), p, 0.5 * Vec3::UnitX(), 0.6 * Vec3::UnitZ()));
        spring.free_length = 0.5;
        turned.free_angle = 0.3;
        spring.law = turned.law = law_of_test();
        spring.friction = turned.friction = kFriction;
    }
    Loads loads() const {
        Loads out;
        out.masses.resize(2);
        out.springs = {spring};
        out.rotational_springs = {turned};
        return out;
    }
};

}  // namespace

TEST_CASE("Friction and law of a spring add what their formulas say", "[core][dynamics][forces]") {
    const Sprung scene;
    std::vector<BodyForce> forces(2);
    add_forces(scene.loads(), scene.bodies, 0.0, forces);
    const double pull = 5.0 * 4.0 - 7.0 + 3.0 * 0.5 + kFriction.at(0.5);
    CHECK(forces[0].f.x() == Approx(pull));
    CHECK(forces[1].f.x() == Approx(-pull));
    // the law of an angle gets the angle itself, not its difference from the free angle
    const double angle = 0.4;
    const double torque = 5.0 * angle * angle - 7.0 + 3.0 * 0.6 + kFriction.at(0.6);
    CHECK(forces[0].n_local.z() == Approx(torque));
    CHECK(forces[1].n_local.z() == Approx(-torque));
}

TEST_CASE("A law of a spring has its integral, its size and its slope", "[core][dynamics][forces]") {
    Sprung scene;
    const auto integral = [](double x) { return 5.0 / 3.0 * x * x * x - 7.0 * x; };
    CHECK(
        potential_energy(scene.loads(), scene.bodies) ==
        Approx(integral(2.0) - integral(0.5) + integral(0.4) - integral(0.3)));
    scene.spring.stiffness = 10.0;
    // a square is off by twice what its operand is off by
    CHECK(
        size_of(scene.spring, scene.bodies, 0.0) ==
        Approx(10.0 * (2.0 + 0.5) + 2.0 * 5.0 * 4.0 + 7.0 + 3.0 * 0.5));
    scene.turned.stiffness = 10.0;
    scene.turned.twist_before = -0.2;
    CHECK(size_of(scene.turned, 0.0) == Approx(10.0 * (1.0 + 0.2 + 0.3) + 2.0 * 5.0 * 0.01 + 7.0));

    scene.turned.twist_before = 0.1;
    Loads loads = scene.loads();
    CHECK(linearise_laws(loads, scene.bodies, 0.0));
    const auto straight = [](double x0, double x, double rate) {
        return 5.0 * x0 * x0 - 7.0 + 10.0 * x0 * (x - x0) + 3.0 * rate;
    };
    CHECK(loads.springs[0].law->at(std::array{2.3, 0.2}) == Approx(straight(2.0, 2.3, 0.2)));
    CHECK(loads.rotational_springs[0].law->at(std::array{0.9, 0.2}) == Approx(straight(0.4, 0.9, 0.2)));
    loads.springs[0].law->steps = {
        {FormulaStep::Kind::variable, 0.0},
        {FormulaStep::Kind::number, 2.0},
        {FormulaStep::Kind::difference},
        {FormulaStep::Kind::absolute}};
    CHECK_FALSE(linearise_laws(loads, scene.bodies, 0.0));
}

TEST_CASE("A spring without length between its ends does not pull", "[core][dynamics][forces]") {
    test::Pair pair = test::random_pair(5);
    pair.moment.state.r[1] = pair.moment.state.r[0];
    Loads loads = test::without_loads(pair.mechanism, 5);
    loads.springs.push_back({0, 1, Vec3::Zero(), Vec3::Zero(), 10.0, 0.5, 1.0});
    const std::vector<BodyForce> forces = test::forces_of(loads, pair.moment);
    CHECK(forces[0].f.norm() + forces[1].f.norm() == 0.0);
}

TEST_CASE(
    "A spring about an axis turns to its free angle by the shorter way, its damper against the turning",
    "[core][dynamics][forces]") {
    const double stiffness = 3.0;
    const double damping = 0.7;
    const double free_angle = 2.5;
    // 2.5 - (-3) is more than half a turn: the shorter way to the free angle is the other one
    for (const double angle : {2.0, -3.0}) {
        for (const double rate : {-1.5, 2.0}) {
            CAPTURE(angle, rate);
            test::Pair pair = test::random_pair(6);
            State& state = pair.moment.state;
            Motion& motion = pair.moment.motion;
            const Vec3 axis = Vec3(1.0, 2.0, 2.0) / 3.0;
            const Vec3 u = perpendicular_to(axis);
            state.p[1] = turned_local(state.p[0], angle * axis);
            // both turn, j about the axis faster by `rate`
            motion.omega_local[1] =
                rotation_matrix(euler_parameters_of(axis, -angle)) * motion.omega_local[0] + rate * axis;
            Loads loads = test::without_loads(pair.mechanism, 6);
            loads.rotational_springs.push_back({0, 1, {axis, u, u}, stiffness, free_angle, damping});
            const std::vector<BodyForce> forces = test::forces_of(loads, pair.moment);
            const double way = angle > 0.0 ? angle - free_angle : angle - free_angle + 2.0 * std::numbers::pi;
            const Vec3 torque = (-stiffness * way - damping * rate) * axis;
            // rounding
            CHECK((forces[1].n_local - torque).norm() < 1e-14);
            CHECK((forces[0].n_local + torque).norm() < 1e-14);
            CHECK(forces[0].f.norm() + forces[1].f.norm() == 0.0);
        }
    }
}

TEST_CASE(
    "A rotational spring counts turns from one pose to the next, either way", "[core][dynamics][forces]") {
    constexpr double stiffness = 3.0;
    constexpr double free_angle = 0.4;
    Loads loads;
    loads.masses.resize(2);
    const Vec3 axis = Vec3(1.0, -2.0, 0.5).normalized();
    const Vec3 u = perpendicular_to(axis);
    loads.rotational_springs.push_back({0, 1, {axis, u, u}, stiffness, free_angle, 0.0});
    // up to three turns and back again, less than half a turn at a time
    for (const double angle :
         {1.0, 3.5, 6.0, 8.5, 11.0, 13.5, 16.0, 18.5, 16.5, 13.6, 11.0, 8.0, 5.0, 2.0, -1.0, -4.0}) {
        CAPTURE(angle);
        const std::vector<BodyKinematics<OmegaLocal>> bodies{
            kinematics_at<OmegaLocal>(Vec3::Zero(), Vec4::Unit(0), Vec3::Zero(), Vec3::Zero()),
            kinematics_at<OmegaLocal>(
                Vec3::Zero(), euler_parameters_of(axis, angle), Vec3::Zero(), Vec3::Zero())};
        std::vector<BodyForce> forces(2);
        add_forces(loads, bodies, 0.0, forces);
        const double way = angle - free_angle;
        // rounding of 60 N m
        CHECK((forces[1].n_local + stiffness * way * axis).norm() < 1e-12);
        CHECK(std::abs(potential_energy(loads, bodies) - 0.5 * stiffness * way * way) < 1e-11);
        count_turns(loads, bodies);
        CHECK(std::abs(loads.rotational_springs[0].twist_before - way) < 1e-13);
    }
}

TEST_CASE(
    "A free angle beyond half a turn counts turns, one within takes the shorter way",
    "[core][dynamics][forces]") {
    constexpr double degree = std::numbers::pi / 180.0;
    struct Case {
        double free_angle, start, twist;  // [deg]
    };
    for (const Case& c :
         {Case{400.0, 0.0, -400.0}, Case{-400.0, 0.0, 400.0}, Case{400.0, 90.0, -310.0},
          Case{200.0, -90.0, -290.0}, Case{720.0, 180.0, -540.0}, Case{720.0, -180.0, -540.0},
          Case{3600.0, 30.0, -3570.0}, Case{170.0, -170.0, 20.0}, Case{-170.0, 100.0, -90.0},
          Case{180.0, -179.0, 1.0}, Case{40.0, 0.0, -40.0}}) {
        CAPTURE(c.free_angle, c.start);
        Loads loads;
        loads.masses.resize(2);
        const Vec3 axis = Vec3(0.3, -1.0, 2.0).normalized();
        const Vec3 u = perpendicular_to(axis);
        loads.rotational_springs.push_back({0, 1, {axis, u, u}, 2.0, c.free_angle * degree, 0.0});
        const std::vector<BodyKinematics<OmegaLocal>> bodies{
            kinematics_at<OmegaLocal>(Vec3::Zero(), Vec4::Unit(0), Vec3::Zero(), Vec3::Zero()),
            kinematics_at<OmegaLocal>(
                Vec3::Zero(), euler_parameters_of(axis, c.start * degree), Vec3::Zero(), Vec3::Zero())};
        begin_turns(loads, bodies);
        std::vector<BodyForce> forces(2);
        add_forces(loads, bodies, 0.0, forces);
        // rounding of 60 rad
        CHECK((forces[1].n_local + 2.0 * c.twist * degree * axis).norm() < 1e-12);
    }
}

TEST_CASE("A body that nothing turns keeps its angular momentum", "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        const Mat3 J = test::random_mass(random).J_local;
        const Vec4 p = random.unit_p();
        const Vec3 omega_local = random.vector(3.0);
        const Vec3 omega_dot = J.inverse() * gyroscopic_torque(J, omega_local);
        const auto momentum = [&](double t) -> Vec3 {
            const Vec4 turned = turned_local(p, t * omega_local);
            return rotation_matrix(turned) * J * (omega_local + t * omega_dot);
        };
        const double h = 1e-5;  // h² and 1e-16 / h are below 1e-9
        CHECK((momentum(h) - momentum(-h)).norm() / (2.0 * h) < 1e-8);
    }
}

TEST_CASE(
    "Energies are ½ m v² + ½ ω·J ω of the bodies and the potential of their unit p", "[core][dynamics]") {
    test::Random random(21);
    for (const Mechanism& mechanism : {test::random_tree(random), test::rssr(0.7)}) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        test::Moment moment = test::random_moment(random, scene, 0.3);
        long double kinetic = 0.0L;
        for (std::size_t b = 0; b < moment.state.r.size(); ++b) {
            if (!scene.loads.masses[b]) { continue; }
            const MassProperties& own = *scene.loads.masses[b];
            const Mat3 A = rotation_matrix(moment.state.p[b]);
            const Vec3 omega = A * moment.motion.omega_local[b];
            for (int k = 0; k < 3; ++k) {
                const long double v = moment.motion.r_dot[b](k);
                kinetic += 0.5L * static_cast<long double>(own.mass) * v * v;
                kinetic +=
                    0.5L * static_cast<long double>(omega(k) * (A * own.J_local * A.transpose() * omega)(k));
            }
        }
        const double potential = potential_energy(scene.loads, test::bodies_of(moment));
        // drift of p changes no energy
        for (Vec4& p : moment.state.p) { p *= 1.0 + 1e-3; }
        const Energy energy = energy_of(scene, moment.state, moment.motion);
        // sums of a hundred products or so
        CHECK(energy.kinetic == Approx(static_cast<double>(kinetic)).epsilon(1e-13));
        CHECK(energy.potential == Approx(potential).epsilon(1e-12).margin(1e-11));
    }
}
