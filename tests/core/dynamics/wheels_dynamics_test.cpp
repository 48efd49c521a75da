#include <catch2/catch.hpp>

#include <cmath>

#include "core/integrate/simulation.hpp"
#include "tests/support/scenes.hpp"

/// Wheels, and a bead on a wire, that are moved by forces, against the freedom that they leave in closed
/// form.
using namespace jw;
using namespace jw::test;

namespace {

std::vector<SimulationSettings> all_ways(double tolerance) {
    std::vector<SimulationSettings> out;
    for (const MethodName& method : kMethods) {
        if (!method.adaptive) { continue; }
        SimulationSettings settings;
        settings.method = method.method;
        settings.tolerance = tolerance;
        out.push_back(settings);
        settings.formulation = Formulation::bodies;
        out.push_back(settings);
        if (method.kind != MethodKind::runge_kutta) { continue; }
        settings.formulation = Formulation::joints;
        out.push_back(settings);
        settings.formulation = Formulation::automatic;
        settings.dense = CoordinateChoice::omega_local;
        out.push_back(settings);
        settings.dense = CoordinateChoice::true_euler_parameters;
        out.push_back(settings);
    }
    return out;
}

/// A ball of inertia J about any axis through the global point `centre`.
MassProperties ball(const SceneBuilder& scene, int body, const Vec3& centre, double mass, double J) {
    return {mass, scene.local_point(body, centre), J * Mat3::Identity()};
}

/// Place of the centre of mass of a body.
Vec3 centre_of(const Simulation& simulation, const std::vector<double>& y, int body) {
    return simulation.point(y, body, simulation.scene().centres[at(body)]);
}

constexpr double kTolerance = 1e-8;

/// Runs a scene in all ways. @param off  distance from the expected position, given (simulation, t, y) [m]
template <class F>
void check_in_all_ways(
    const Mechanism& mechanism, const Loads& loads, const std::vector<double>& times, double bound, F&& off) {
    for (const SimulationSettings& settings : all_ways(kTolerance)) {
        CAPTURE(entry_of(settings.method).name, static_cast<int>(settings.formulation));
        Simulation simulation(mechanism, loads, settings);
        double worst = 0.0;
        const auto outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
            worst = std::max(worst, off(simulation, t, y));
        });
        CHECK_FALSE(outcome.failure);
        CHECK(worst < bound);
    }
}

}  // namespace

TEST_CASE("A falling rack turns its pinion, with both inertias, over many turns", "[dynamics][wheels]") {
    const double r = GENERATE(0.4, -0.15);
    SceneBuilder scene;
    scene.mechanism = rack_and_pinion(r);
    const Vec3 axis = Vec3(2.0, 2.0, 1.0) / 3.0;
    const Vec3 along = perpendicular_to(axis);
    constexpr double m = 1.3;
    constexpr double J = 0.05;
    Loads loads;
    loads.masses = {std::nullopt, ball(scene, 1, Vec3::Zero(), 2.0, J), ball(scene, 2, Vec3::Zero(), m, 0.2)};
    loads.gravity = Vec3(1.0, -4.0, -8.0);
    const double acceleration = loads.gravity.dot(along) * m / (m + J / (r * r));
    const auto off = [&](const Simulation& simulation, double t, const std::vector<double>& y) {
        const Vec3 expected = 0.5 * acceleration * t * t * along;
        // θ of the rack at the pose, turns included
        const double theta = simulation.snapshot(t, y).state.theta[0];
        return std::max(
            (centre_of(simulation, y, 2) - expected).norm(), std::abs(r * theta + expected.dot(along)));
    };
    // 25 m of way at most: the tolerance is relative to the extent of less than 1 m, in each second
    check_in_all_ways(scene.mechanism, loads, {0.0, 1.0, 2.0, 3.0}, 100.0 * kTolerance, off);
}

TEST_CASE("A planetary gear under a torque turns with the inertia of all its wheels", "[dynamics][wheels]") {
    const double outer = -24.0 / 18.0;
    const double inner = 18.0 / 60.0;
    const Vec3 axis = Vec3(2.0, -1.0, 2.0) / 3.0;
    SceneBuilder scene;
    scene.mechanism = planetary_gear(outer, inner, 3.0 * axis);
    const Vec3 arm = 1.05 * perpendicular_to(axis);
    Loads loads;
    loads.masses = {
        std::nullopt, ball(scene, 1, Vec3::Zero(), 1.0, 0.02), ball(scene, 2, Vec3::Zero(), 0.7, 0.05),
        ball(scene, 3, arm, 0.4, 0.01)};
    AppliedTorque torque;
    torque.body = 1;
    torque.direction = axis;
    torque.frame = Frame::global;
    torque.magnitude = polynomial({0.9});
    loads.torques.push_back(torque);
    const double carrier = outer * inner / (outer * inner - 1.0);
    const double planet = carrier + outer * (1.0 - carrier);
    const double inertia = 0.02 + (0.05 + 0.4 * 1.05 * 1.05) * carrier * carrier + 0.01 * planet * planet;
    const auto off = [&](const Simulation& simulation, double t, const std::vector<double>& y) {
        const double turned = carrier * 0.5 * 0.9 / inertia * t * t;
        const Vec3 expected = std::cos(turned) * arm + std::sin(turned) * axis.cross(arm);
        return (centre_of(simulation, y, 3) - expected).norm();
    };
    // ten turns of the sun: its rate of 60 rad/s passes errors on
    check_in_all_ways(scene.mechanism, loads, {0.0, 0.5, 1.3, 2.0}, 1000.0 * kTolerance, off);
}

TEST_CASE("A bead slides down a helical wire as down a straight one", "[dynamics][curves]") {
    const double R = GENERATE(0.3, 0.05);
    const double h = GENERATE(0.1, -0.04);
    SceneBuilder scene;
    const int bead = scene.add_body("bead", Vec3(0.1, 0.2, -0.3));
    const Vec3 start = Vec3(0.4, -0.2, 0.1);
    const Vec3 down = Vec3(1.0, 2.0, -2.0) / 3.0;
    const Vec3 a = scene.local(0, perpendicular_to(down));
    const Vec3 b = scene.local(0, down.cross(perpendicular_to(down)));
    const Curve helix{Vec3::Zero(), h * scene.local(0, down), {{R * a, R * b}}};
    scene.add_curve(0, bead, start, 0.3, helix);
    Loads loads;
    loads.masses = {std::nullopt, ball(scene, bead, start, 0.6, 0.01)};
    loads.gravity = 9.0 * down;
    const double acceleration = 9.0 * h / (R * R + h * h);
    const auto off = [&](const Simulation& simulation, double t, const std::vector<double>& y) {
        const double theta = 0.3 + 0.5 * acceleration * t * t;
        const Vec3 moved = helix.at(theta).c - helix.at(0.3).c;
        const Vec3 expected = start + rotation_matrix(scene.mechanism.bodies[0].p) * moved;
        return (centre_of(simulation, y, bead) - expected).norm();
    };
    // up to thirty turns of the wire, each with the tolerance
    check_in_all_ways(scene.mechanism, loads, {0.0, 0.4, 1.0}, 1000.0 * kTolerance, off);
}
