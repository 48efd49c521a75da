#include <catch2/catch.hpp>

#include <cmath>

#include "core/integrate/simulation.hpp"
#include "tests/support/random_dynamics.hpp"

/// Independence of units: a scene in other units of length, time and mass moves as before.
namespace jw {

namespace {

/// Powers of two: scaling a number rounds nothing, so that all steps are the same.
struct Units {
    double length;
    double time;
    double mass;
};

constexpr Units kUnits[] = {
    {1.0, 1.0, 1.0},          {0x1p-10, 1.0, 1.0}, {0x1p10, 1.0, 1.0}, {0x1p-10, 0x1p-10, 0x1p-20},
    {0x1p10, 0x1p10, 0x1p20},
};

/// A body on two planes that are not parallel, without a load: along both it slides at constant velocity.
struct Slide {
    Mechanism mechanism;
    Loads loads;
    Vec3 start;
    Vec3 velocity;
};

Slide slide(unsigned seed, const Units& units) {
    test::Random random(seed);
    test::SceneBuilder scene;
    const int body = scene.add_body("body", random.vector(1.0));
    const Vec3 normal = random.direction();
    const Vec3 other = (normal + perpendicular_to(normal) * random.number(0.5, 2.0)).normalized();
    scene.add_joint("planar", 0, body, random.vector(1.0), normal);
    scene.add_joint("planar", 0, body, random.vector(1.0), other);
    Mechanism& mechanism = scene.mechanism;
    mechanism.bodies.back().r_dot = random.number(0.5, 2.0) / units.time * normal.cross(other).normalized();
    for (Body& each : mechanism.bodies) {
        each.r *= units.length;
        each.r_dot *= units.length;
    }
    for (Joint& joint : mechanism.joints) {
        joint.geometry.P_i_local *= units.length;
        joint.geometry.P_j_local *= units.length;
    }
    Loads loads;
    loads.masses = {std::nullopt, test::random_mass(random)};
    MassProperties& mass = *loads.masses.back();
    mass.mass *= units.mass;
    mass.centre_local *= units.length;
    mass.J_local *= units.mass * units.length * units.length;
    return {mechanism, loads, mechanism.bodies.back().r, mechanism.bodies.back().r_dot};
}

}  // namespace

TEST_CASE("A body between planes slides along them in every method, in any units", "[dynamics]") {
    for (unsigned seed = 0; seed < 10; ++seed) {
        for (const Method method :
             {Method::explicit_5, Method::explicit_8, Method::implicit_5, Method::implicit_9}) {
            long steps = 0;
            for (const Units& units : kUnits) {
                CAPTURE(seed, entry_of(method).name, units.length, units.time, units.mass);
                const Slide slid = slide(seed, units);
                SimulationSettings settings;
                settings.method = method;
                settings.tolerance = 1e-9;
                settings.formulation = Formulation::bodies;
                // a run that makes no progress fails instead of running for ever
                settings.most_steps = 1000;
                Simulation simulation(slid.mechanism, slid.loads, settings);
                double most = 0.0;
                const auto outcome = simulation.run(
                    {0.0, 0.3 * units.time, units.time}, [&](double t, const std::vector<double>& y) {
                        const Vec3 here = simulation.point(y, 1, Vec3::Zero());
                        most = std::max(most, (here - slid.start - t * slid.velocity).norm());
                    });
                CHECK_FALSE(outcome.failure);
                // a way of one length, by a polynomial that is exact: 1e-9 of a step at most
                CHECK(most <= 1e-8 * units.length);
                if (steps == 0) { steps = outcome.counts.steps; }
                CHECK(outcome.counts.steps == steps);
            }
        }
    }
}

}  // namespace jw
