#include <catch2/catch.hpp>

#include "tests/support/fixed_steps.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

/// A problem of the IFToMM library of computational benchmark problems.
struct Problem {
    Mechanism mechanism;
    Loads loads;
    int body = 1;
    Vec3 point_local = Vec3::Zero();  ///< of the body's frame
};

/// A01: point-like mass 1 m from its pin, at rest at (-1, 0, 0).
Problem pendulum() {
    test::SceneBuilder builder;
    const int body = builder.add_body("mass", Vec3(-1.0, 0.0, 0.0));
    builder.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    Problem out{builder.mechanism, {}};
    out.loads.masses = {std::nullopt, MassProperties{1.0, Vec3::Zero(), 1e-3 * Mat3::Identity()}};
    out.loads.gravity = Vec3(0.0, -9.81, 0.0);
    return out;
}

/// A02 with N = 1: three rods of 1 m, the cranks turning with -1 rad/s.
Problem parallelogram() {
    test::SceneBuilder builder;
    const Vec3 up = Vec3::UnitY();
    const Vec3 along = Vec3::UnitX();
    const Vec3 z = Vec3::UnitZ();
    const int left = builder.add_body("left", 0.5 * up);
    const int coupler = builder.add_body("coupler", up + 0.5 * along);
    const int right = builder.add_body("right", along + 0.5 * up);
    builder.add_joint("revolute", 0, left, Vec3::Zero(), z);
    builder.add_joint("revolute", left, coupler, up, z);
    builder.add_joint("revolute", coupler, right, up + along, z);
    builder.add_joint("revolute", 0, right, along, z);
    Problem out{builder.mechanism, {}};
    out.body = left;
    out.point_local = builder.local_point(left, up);
    const Vec3 omega = -z;
    for (const int b : {left, coupler, right}) {
        Body& body = out.mechanism.bodies[static_cast<std::size_t>(b)];
        body.r_dot = omega.cross(b == coupler ? up : 0.5 * up);
        if (b != coupler) { body.omega_local = builder.local(b, omega); }
    }
    // the same moment of inertia about all axes: only the one about z matters
    out.loads.masses.assign(4, MassProperties{1.0, Vec3::Zero(), Mat3::Identity() / 12.0});
    out.loads.masses[0].reset();
    out.loads.gravity = Vec3(0.0, -9.81, 0.0);
    return out;
}

/// Position of the point of a problem at `duration`.
template <class C>
Vec3 end_point(const Problem& problem, double duration, int steps) {
    const Centroidal scene = centroidal(problem.mechanism, problem.loads);
    DenseEquations<C> equations(scene);
    std::vector<double> y(static_cast<std::size_t>(equations.size()));
    State state = start_state(scene.mechanism);
    Motion motion = start_motion(scene.mechanism);
    equations.pack(state, motion, y.data());
    y = test::run(equations, dormand_prince_853(), y, duration, steps, true);
    equations.unpack(y.data(), state, motion);
    const auto b = static_cast<std::size_t>(problem.body);
    return state.r[b] + rotation_matrix(state.p[b]) * problem.point_local;
}

/// Position of the point at `duration` by the block equations.
Vec3 end_point_of_blocks(const Problem& problem, double duration, int steps) {
    const Centroidal scene = centroidal(problem.mechanism, problem.loads);
    const std::unique_ptr<MotionEquations> equations = block_equations(scene);
    const std::vector<int> moving = moving_bodies_of(scene.mechanism);
    std::vector<double> y(static_cast<std::size_t>(equations->size()));
    State state = start_state(scene.mechanism);
    Motion motion = start_motion(scene.mechanism);
    pack(state, motion, moving, y.data());
    y = test::run(*equations, dormand_prince_853(), y, duration, steps, true);
    unpack(y.data(), moving, state, motion);
    const auto b = static_cast<std::size_t>(problem.body);
    return state.r[b] + rotation_matrix(state.p[b]) * problem.point_local;
}

/// The parallelogram as one equation for the angle of its cranks from the upright, clockwise:
/// φ'' = g sin φ ((N+1)/2 + N) / ((N+1)/3 + N), N = 1.
Vec3 parallelogram_by_its_angle(double duration, int steps) {
    const double factor = 9.81 * 2.0 / (5.0 / 3.0);
    std::vector<double> phi{0.0, 1.0};
    const auto f = [&](double, const double* y, double* y_dot) {
        y_dot[0] = y[1];
        y_dot[1] = factor * std::sin(y[0]);
    };
    const double h = duration / steps;
    for (int n = 0; n < steps; ++n) { take_step(dormand_prince_853(), f, n * h, h, phi); }
    return {std::sin(phi[0]), std::cos(phi[0]), 0.0};
}

}  // namespace

TEST_CASE("A pendulum is where the 14 trusted digits of its reference say", "[core][dynamics][references]") {
    const Vec3 reference(-0.295850422283221, -0.955234278925772, 0.0);
    const Problem problem = pendulum();
    // 4 turns to and fro in 1000 steps of order 8: 5e-13 measured
    CHECK((end_point_of_blocks(problem, 10.0, 1000) - reference).norm() < 1e-11);
    CHECK((end_point<OmegaLocal>(problem, 10.0, 1000) - reference).norm() < 1e-11);
    CHECK((end_point<OmegaGlobal>(problem, 10.0, 1000) - reference).norm() < 1e-11);
    CHECK((end_point<TrueEulerParameters>(problem, 10.0, 1000) - reference).norm() < 1e-11);
    CHECK((end_point<ModifiedEulerParameters>(problem, 10.0, 1000) - reference).norm() < 1e-11);
}

TEST_CASE(
    "A parallelogram of rods follows its reference through all its singular positions",
    "[core][dynamics][references]") {
    const double x = 0.478385057760971;
    const Vec3 reference(x, std::sqrt(1.0 - x * x), 0.0);
    // rounding of 2000 steps; 15 digits are given
    CHECK((parallelogram_by_its_angle(10.0, 2000) - reference).norm() < 1e-12);
    const Problem problem = parallelogram();
    // a stage next to a singular position costs digits, and fixed steps do not avoid it: 8e-8 measured
    CHECK((end_point<OmegaLocal>(problem, 10.0, 1000) - reference).norm() < 1e-6);
    CHECK((end_point<OmegaGlobal>(problem, 10.0, 1000) - reference).norm() < 1e-6);
}
