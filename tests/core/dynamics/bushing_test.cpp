#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

/// Rotation vector of a bushing's axes in j against those in i, by Eigen.
Vec3 turn_of(const Bushing& bushing, const Mat3& A_i, const Mat3& A_j) {
    const Eigen::AngleAxisd turn(
        Mat3(bushing.axes_i_local.transpose() * A_i.transpose() * A_j * bushing.axes_j_local));
    return turn.angle() * turn.axis();
}

}  // namespace

TEST_CASE(
    "A bushing stores k/2 times the squares of its displacement and of its turn",
    "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const test::Pair pair = test::random_pair(seed);
        test::Random random(seed);
        Loads loads = test::without_loads(pair.mechanism, seed);
        const Bushing bushing = test::random_bushing(random, 0, 1);
        loads.bushings = {bushing};
        const auto bodies = test::bodies_of(pair.moment);
        const Vec3 d =
            bushing.axes_i_local.transpose() * bodies[0].A.transpose() *
            (bodies[1].r + bodies[1].A * bushing.P_j_local - bodies[0].r - bodies[0].A * bushing.P_i_local);
        const Vec3 phi = turn_of(bushing, bodies[0].A, bodies[1].A);
        double energy = 0.0;
        for (int k = 0; k < 3; ++k) {
            energy += 0.5 * bushing.stiffness[k] * d[k] * d[k];
            energy += 0.5 * bushing.rotational_stiffness[k] * phi[k] * phi[k];
        }
        CHECK(potential_energy(loads, bodies) == Approx(energy).epsilon(1e-13));  // rounding
    }
}

TEST_CASE(
    "A bushing takes c times the squares of its rates, and pushes both bodies alike",
    "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const test::Pair pair = test::random_pair(seed);
        test::Random random(seed);
        Loads loads = test::without_loads(pair.mechanism, seed);
        Bushing bushing = test::random_bushing(random, 0, 1);
        bushing.stiffness = bushing.rotational_stiffness = Vec3::Zero();
        bushing.damping = Vec3(0.3, 1.1, 0.7);
        bushing.rotational_damping = Vec3(1.3, 0.2, 0.6);
        loads.bushings = {bushing};
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
        const auto yielding_at = [&](double t) {
            const auto turned = [&](std::size_t b) -> Mat3 {
                return rotation_matrix(turned_local(bodies[b].p, t * pair.moment.motion.omega_local[b]));
            };
            const auto end = [&](std::size_t b, const Vec3& P) -> Vec3 {
                return bodies[b].r + t * bodies[b].r_dot + turned(b) * P;
            };
            Eigen::Matrix<double, 6, 1> out;
            out << bushing.axes_i_local.transpose() * turned(0).transpose() *
                       (end(1, bushing.P_j_local) - end(0, bushing.P_i_local)),
                turn_of(bushing, turned(0), turned(1));
            return out;
        };
        const double h = 1e-5;  // h² and 1e-16 / h are below 1e-9
        const Eigen::Matrix<double, 6, 1> rate = (yielding_at(h) - yielding_at(-h)) / (2.0 * h);
        double taken = 0.0;
        for (int k = 0; k < 3; ++k) {
            taken += bushing.damping[k] * rate[k] * rate[k];
            taken += bushing.rotational_damping[k] * rate[k + 3] * rate[k + 3];
        }
        CHECK(std::abs(power + taken) < 1e-8 * (1.0 + taken));
        CHECK(total.norm() < 1e-13);   // rounding
        CHECK(torque.norm() < 1e-12);  // rounding
    }
}

TEST_CASE("A bushing at exactly half a turn has the energy k π² / 2", "[core][dynamics][forces]") {
    for (const Vec3& axis : {Vec3(0.0, 0.0, 1.0), Vec3(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0)}) {
        test::Pair pair = test::random_pair(3);
        Loads loads = test::without_loads(pair.mechanism, 3);
        Bushing bushing;
        bushing.body_j = 1;
        bushing.rotational_stiffness = Vec3(2.0, 3.0, 5.0);
        loads.bushings = {bushing};
        pair.moment.state.p[0] = Vec4(1.0, 0.0, 0.0, 0.0);
        pair.moment.state.p[1] << 0.0, axis;
        const double k = axis.cwiseAbs2().dot(bushing.rotational_stiffness);
        const double square = std::numbers::pi * std::numbers::pi;
        CHECK(
            potential_energy(loads, test::bodies_of(pair.moment)) == Approx(0.5 * k * square).epsilon(1e-13));
    }
}

TEST_CASE(
    "A bushing without a turn, or with a very small one, has the torque k φ", "[core][dynamics][forces]") {
    const test::Pair pair = test::random_pair(3);
    for (const double angle : {0.0, 1e-300, 1e-160, 1e-12, 1e-5}) {
        CAPTURE(angle);
        Bushing bushing;
        bushing.body_j = 1;
        bushing.rotational_stiffness = Vec3(2.0, 3.0, 5.0);
        Loads loads = test::without_loads(pair.mechanism, 3);
        loads.bushings = {bushing};
        test::Moment moment = pair.moment;
        moment.state.p[0] = Vec4(1.0, 0.0, 0.0, 0.0);
        moment.state.p[1] = Vec4(1.0, 0.5 * angle, 0.0, -0.5 * angle).normalized();
        const std::vector<BodyForce> forces = test::forces_of(loads, moment);
        // φ̃ k φ / 2 is of second order
        CHECK(
            (forces[0].n_local - Vec3(2.0 * angle, 0.0, -5.0 * angle)).norm() <=
            4.0 * angle * angle + 1e-15 * angle);
    }
}

TEST_CASE(
    "A bushing has the same energy in the frames as given and at the centres of mass",
    "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(seed);
        const test::Pair pair = test::random_pair(seed);
        test::Random random(seed);
        Loads loads = test::without_loads(pair.mechanism, seed);
        loads.bushings = {test::random_bushing(random, 0, 1)};
        const Centroidal scene = centroidal(pair.mechanism, loads);
        REQUIRE(scene.centres[0].norm() * scene.centres[1].norm() > 1e-3);
        const State& given = pair.moment.state;
        const double as_given = potential_energy(loads, kinematics_of(given));
        const double at_centres = potential_energy(scene.loads, kinematics_of(scene.to_centroidal(given)));
        CHECK(at_centres == Approx(as_given).epsilon(1e-13));  // rounding
    }
}

TEST_CASE(
    "The size of a bushing's force is that of its springs, and its torque over a length",
    "[core][dynamics][forces]") {
    const test::Pair pair = test::random_pair(7);
    test::Random random(7);
    const Bushing bushing = test::random_bushing(random, 0, 1);
    const auto bodies = test::bodies_of(pair.moment);
    const double length = 3.0;
    const Vec3 d =
        bodies[1].r + bodies[1].A * bushing.P_j_local - bodies[0].r - bodies[0].A * bushing.P_i_local;
    const Eigen::AngleAxisd turn(Mat3(
        bushing.axes_i_local.transpose() * bodies[0].A.transpose() * bodies[1].A * bushing.axes_j_local));
    const double expected = bushing.stiffness.maxCoeff() * d.norm() +
                            bushing.rotational_stiffness.maxCoeff() * (1.0 + turn.angle()) / length;
    CHECK(size_of(bushing, bodies, length) == Approx(expected).epsilon(1e-13));
}
