#include <catch2/catch.hpp>

#include <cmath>

#include <Eigen/QR>

#include "core/poses/newton.hpp"
#include "tests/support/scenes.hpp"

/// Effect of the rows pᵀp = 1 on Newton's method.
using namespace jw;
using test::radians;

namespace {

struct Start {
    Mechanism mechanism;
    State state;
};

/// A revolute at arm (1, 2, -1), body j turned off by 30 deg and its p longer than 1.
Start revolute_off(double length) {
    Start start;
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    const Vec3 axis(2.0, 3.0, 6.0);
    scene.add_joint("revolute", 0, body, Vec3(1.0, 2.0, -1.0), axis);
    start.mechanism = scene.mechanism;
    start.state = start_state(scene.mechanism);
    start.state.p[1] = length * turned_global(start.state.p[1], radians(30.0) * perpendicular_to(axis));
    return start;
}

struct Run {
    std::vector<double> residuals;
    State state;
};

enum class Normalise { never, every_step };

/// Newton as on slide 23, whole steps: Φ with the A of `Equations`, matrix of `Matrix`; the last `left_out`
/// rows are not used.
template <class Equations, class Matrix>
Run whole_steps(
    const Start& start, int iterations, int left_out = 0, Normalise normalise = Normalise::never) {
    const System system(start.mechanism, everything(start.mechanism));
    Assembler<Equations> equations(system);
    Assembler<Matrix> matrix(system);
    Run run{{}, start.state};
    for (int k = 0; k < iterations; ++k) {
        equations.assemble_phi_and_jacobian(run.state, 0.0);
        matrix.assemble_phi_and_jacobian(run.state, 0.0);
        run.residuals.push_back(equations.phi().cwiseAbs().maxCoeff());
        const Eigen::Index rows = equations.phi().size() - left_out;
        const VectorX delta = matrix.jacobian().topRows(rows).completeOrthogonalDecomposition().solve(
            -equations.phi().head(rows));
        equations.layout().advance(run.state, delta);
        if (normalise == Normalise::every_step) { run.state.p[1].normalize(); }
    }
    return run;
}

void check_like(const std::vector<double>& residuals, const std::vector<double>& table) {
    for (std::size_t k = 0; k < table.size(); ++k) {
        CAPTURE(k, residuals[k]);
        // the table is for another axis and pose: quadratic convergence turns 1.5 at 1e-2 into four later
        CHECK(residuals[k] < 4.0 * table[k] + 1e-14);
        CHECK(residuals[k] > table[k] / 10.0 - 1e-14);
    }
}

}  // namespace

TEST_CASE("From |p| = 1.2 and 30 deg off, whole Newton steps converge as tabled", "[core][normalisation]") {
    const Start start = revolute_off(1.2);
    const Run with_true = whole_steps<TrueEulerParameters, TrueEulerParameters>(start, 6);
    check_like(with_true.residuals, {2.0, 0.29, 1.0e-2, 2.3e-5, 8.8e-11, 2e-16});
    const Run with_modified = whole_steps<ModifiedEulerParameters, ModifiedEulerParameters>(start, 6);
    check_like(with_modified.residuals, {1.1, 0.14, 6.8e-3, 1.6e-5, 5.8e-11, 0.0});
}

TEST_CASE(
    "The modified Jacobian with the equations of slide 24 converges too, some iterations later",
    "[core][normalisation]") {
    const Start start = revolute_off(1.2);
    const Run mixed = whole_steps<TrueEulerParameters, ModifiedEulerParameters>(start, 10);
    CHECK(mixed.residuals[4] > 1e-9);  // where the matching pair is at 1e-10
    CHECK(mixed.residuals[9] < 1e-14);

    // with p made unit after every step the two matrices differ by c pᵀ only, and pᵀΔp = 0
    const Start unit = revolute_off(1.0);
    const Run pure = whole_steps<TrueEulerParameters, TrueEulerParameters>(unit, 7, 0, Normalise::every_step);
    const Run same =
        whole_steps<TrueEulerParameters, ModifiedEulerParameters>(unit, 7, 0, Normalise::every_step);
    for (std::size_t k = 0; k < pure.residuals.size(); ++k) {
        CAPTURE(k);
        CHECK(std::abs(pure.residuals[k] - same.residuals[k]) < 1e-13);  // rounding, some hundred of them
    }
    CHECK(pure.residuals.back() < 1e-14);
}

TEMPLATE_TEST_CASE(
    "The stepper brings |p| = 1.2 to 1 with at most two iterations more for its step limit",
    "[core][normalisation]", TrueEulerParameters, ModifiedEulerParameters) {
    const Start start = revolute_off(1.2);
    const System system(start.mechanism, everything(start.mechanism));
    NewtonStepper<TestType> stepper(system);
    stepper.start(start.state, 0.0);
    const NewtonOutcome outcome = solve(stepper);
    CHECK(outcome.converged);
    CHECK(outcome.iterations <= 7);
    for (const Vec4& p : stepper.state().p) { CHECK(std::abs(p.norm() - 1.0) < 1e-15); }
}

TEMPLATE_TEST_CASE(
    "Without the rows Newton leaves |p| free and A_N is no rotation", "[core][normalisation]",
    TrueEulerParameters, ModifiedEulerParameters) {
    const Run run = whole_steps<TestType, TestType>(revolute_off(1.2), 12, 1);
    const Vec4& p = run.state.p[1];
    CHECK(std::abs(p.squaredNorm() - 1.0) > 1e-3);  // of 0.44 at the start, and no iteration removes it
    const Mat3 A = rotation_matrix(p);
    CHECK((A.transpose() * A - Mat3::Identity()).norm() > 1e-3);
}
