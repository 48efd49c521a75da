#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "tests/support/random_dynamics.hpp"

using namespace jw;

TEST_CASE(
    "A bushing has the same energy in the frames as given and at the centres of mass", "[core][forces]") {
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
    "The size of a bushing's force is that of its springs, and its torque over a length", "[core][forces]") {
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
