#include <catch2/catch.hpp>

#include <cmath>

#include "core/poses/newton.hpp"
#include "tests/support/scenes.hpp"

using namespace jw;
using test::radians;

namespace {

struct NamedScene {
    const char* name;
    Mechanism mechanism;
};

/// Driven so that the solution is one point; the loops have up to three redundant rows.
std::vector<NamedScene> named_scenes() {
    std::vector<NamedScene> scenes{
        {"four-bar", test::four_bar_at(0.7)},
        {"four-bar R-S-C-R",
         test::four_bar_at(0.7, {}, {"revolute", "spherical", "cylindrical", "revolute"})},
        {"slider-crank", test::slider_crank(1.0, 3.0, 0.7)},
        {"RSSR", test::rssr(0.7)},
        {"Bennett", test::bennett(0.7)},
        {"double Cardan", test::double_cardan(0.4, 0.3)},
        {"screw", test::screw(0.7, 0.25, ScrewAngleForm::rotation)}};
    for (NamedScene& scene : scenes) {
        const double angle = relative_angle(scene.mechanism.joints[0], start_state(scene.mechanism));
        test::drive_angle(scene.mechanism, 0, test::polynomial({angle}));
    }
    return scenes;
}

template <class C>
std::vector<NewtonStep> steps_from(const System& system, const State& state) {
    NewtonStepper<C> stepper(system);
    stepper.start(state, 0.0);
    std::vector<NewtonStep> steps;
    solve(stepper, [&](const NewtonStep& step) { steps.push_back(step); });
    return steps;
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Near the solution every residual is bounded by the square of the one before", "[core][newton]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const NamedScene& scene : named_scenes()) {
        const System system(scene.mechanism, everything(scene.mechanism));
        double worst = 0.0;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            test::Random random(seed);
            const State start =
                test::disturbed(scene.mechanism, start_state(scene.mechanism), random, 0.05, 0.05);
            const std::vector<NewtonStep> steps = steps_from<TestType>(system, start);
            CAPTURE(scene.name, seed);
            REQUIRE(steps.back().converged);
            CHECK(steps.size() <= 6);  // 0.1, 1e-2, 1e-4, 1e-8, 1e-16 and the final check
            for (std::size_t k = 1; k < steps.size(); ++k) {
                const double before = steps[k - 1].residual;
                // 1e-13 is rounding; a square below it shows nothing
                const double ratio = std::max(0.0, steps[k].residual - 1e-13) / (before * before);
                worst = std::max(worst, ratio);
            }
        }
        CAPTURE(scene.name);
        // curvature over the square of the smallest singular value: 1/2 / 0.2² is 12
        CHECK(worst < 12.0);
    }
}

TEMPLATE_TEST_CASE(
    "An assembled scene needs no iteration and is not changed", "[core][newton]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const NamedScene& scene : named_scenes()) {
        CAPTURE(scene.name);
        const System system(scene.mechanism, everything(scene.mechanism));
        NewtonStepper<TestType> stepper(system);
        const State start = start_state(scene.mechanism);
        stepper.start(start, 0.0);
        const NewtonOutcome outcome = solve(stepper);
        CHECK(outcome.converged);
        CHECK_FALSE(outcome.at_floor);
        CHECK(outcome.iterations == 0);
        for (std::size_t b = 0; b < start.r.size(); ++b) {
            CHECK(stepper.state().r[b] == start.r[b]);
            // made unit once more: one rounding
            CHECK((stepper.state().p[b] - start.p[b]).norm() < 1e-15);
        }
    }
}

TEMPLATE_TEST_CASE(
    "Redundant rows are solved with all rows at zero in the end", "[core][newton]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    // undriven, so that the solution is a curve; four-bar and Bennett have 3 redundant rows, Bricard 1
    for (const Mechanism& mechanism :
         {test::four_bar_at(0.7), test::bennett(1.1), test::bricard(1.2), test::cardan(0.5, 0.3)}) {
        const System system(mechanism, everything(mechanism));
        for (unsigned seed = 1; seed <= 20; ++seed) {
            test::Random random(seed);
            CAPTURE(mechanism.joints.size(), seed);
            const State start = test::disturbed(mechanism, start_state(mechanism), random, 0.1, 0.1);
            NewtonStepper<TestType> stepper(system);
            stepper.start(start, 0.0);
            const NewtonOutcome outcome = solve(stepper);
            CHECK(outcome.converged);
            CHECK(outcome.iterations <= 7);
            Assembler<OmegaLocal> assembler(system);
            assembler.assemble_phi_and_jacobian(stepper.state(), 0.0);
            // every row, the redundant ones too: a hundred roundings
            CHECK(assembler.phi().cwiseAbs().maxCoeff() < 1e-13 * 10.0);
            for (const Vec4& p : stepper.state().p) { CHECK(std::abs(p.norm() - 1.0) < 1e-15 * 5.0); }
        }
    }
}

TEMPLATE_TEST_CASE(
    "No iteration turns a body by more than 0.5 rad", "[core][newton]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        test::Random random(seed);
        Mechanism mechanism = test::four_bar_at(0.7);
        const System system(mechanism, everything(mechanism));
        NewtonStepper<TestType> stepper(system);
        stepper.start(test::disturbed(mechanism, start_state(mechanism), random, 0.8, 1.5), 0.0);
        CAPTURE(seed);
        bool limited = false;
        while (!stepper.outcome()) {
            const State before = stepper.state();
            const NewtonStep step = stepper.step();
            if (step.converged) { break; }
            CHECK(step.fraction > 0.0);
            CHECK(step.fraction <= 1.0);
            CHECK(step.fraction * step.turn <= kLargestTurn * (1.0 + 1e-15));
            CHECK((step.fraction < 1.0) == (step.turn > kLargestTurn));
            limited = limited || step.fraction < 1.0;
            if constexpr (!TestType::kNormalised) {
                for (const int b : system.moving_bodies()) {
                    const auto k = static_cast<std::size_t>(b);
                    // the bound itself, measured on the bodies; 1e-9 is rounding only, since no acos is used
                    CHECK(
                        turn_local_between(before.p[k], stepper.state().p[k]).norm() <= kLargestTurn + 1e-9);
                }
            }
        }
        CHECK(stepper.outcome().has_value());
    }
}

TEMPLATE_TEST_CASE(
    "A revolute closes from 30 deg of misalignment in a few iterations", "[core][newton]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        test::SceneBuilder scene;
        const int body = scene.add_body("body", random.vector());
        const Vec3 axis = random.direction();
        scene.add_joint("revolute", 0, body, random.vector(), axis);
        const System system(scene.mechanism, everything(scene.mechanism));
        State start = start_state(scene.mechanism);
        start.p[1] = turned_global(start.p[1], radians(30.0) * perpendicular_to(axis));
        const std::vector<NewtonStep> steps = steps_from<TestType>(system, start);
        CAPTURE(seed);
        CHECK(steps.back().converged);
        CHECK(steps.back().iteration <= 6);
        CHECK(steps.back().residual < 1e-13);
    }
}

TEST_CASE("Every iteration reports its residual, the row where it is and the rank", "[core][newton]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    test::Random random(1);
    const State start = test::disturbed(mechanism, start_state(mechanism), random, 0.05, 0.05);
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(start, 0.0);
    const std::vector<NewtonStep> steps = steps_from<OmegaLocal>(system, start);
    const NewtonStep& first = steps.front();
    CHECK(first.iteration == 0);
    CHECK(first.phi_norm == assembler.phi().norm());
    CHECK(first.largest_value == assembler.phi()(first.largest_row));
    CHECK(first.residual == assembler.phi().cwiseAbs().maxCoeff());
    CHECK(first.delta_norm > 0.0);
    for (std::size_t k = 0; k < steps.size(); ++k) { CHECK(steps[k].iteration == static_cast<int>(k)); }
    // near the solution the rank that Newton's method uses is the kinematic one
    CHECK(steps[steps.size() - 2].rank == 17);
}

TEST_CASE("A start with NaN ends at once, not converged", "[core][newton]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    State start = start_state(mechanism);
    start.r[1].x() = std::nan("");
    NewtonStepper<OmegaLocal> stepper(system);
    stepper.start(start, 0.0);
    const NewtonOutcome outcome = solve(stepper);
    CHECK_FALSE(outcome.converged);
    CHECK(outcome.iterations == 0);
}

TEMPLATE_TEST_CASE(
    "Machines of a millimetre and of a kilometre, near and far from the origin, close in as many iterations",
    "[core][newton]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const NamedScene& scene : named_scenes()) {
        test::Random random(6);
        const State off = test::disturbed(scene.mechanism, start_state(scene.mechanism), random, 0.1, 0.1);
        Mechanism start = scene.mechanism;
        for (std::size_t b = 0; b < start.bodies.size(); ++b) {
            start.bodies[b].r = off.r[b];
            start.bodies[b].p = off.p[b];
        }
        const auto iterations = [&](const Mechanism& mechanism) {
            const System system(mechanism, everything(mechanism));
            NewtonStepper<TestType> stepper(system);
            stepper.start(start_state(mechanism), 0.0);
            const NewtonOutcome outcome = solve(stepper);
            CHECK(outcome.converged);
            CHECK_FALSE(outcome.at_floor);
            return outcome.iterations;
        };
        const int usual = iterations(start);
        CHECK(usual <= 6);
        for (const double factor : {1e-6, 1e-3, 1e3, 1e6}) {
            CAPTURE(scene.name, factor);
            CHECK(iterations(scaled(start, factor)) == usual);
        }
        for (const double factor : {0.05, 8.0, 300.0}) {
            CAPTURE(scene.name, factor);
            // the unit of length stays a power of 1000: the weights between metres and radians change, and
            // with them an iteration or two that leave out weak rows
            CHECK(std::abs(iterations(scaled(start, factor)) - usual) <= 2);
        }
        for (const double distance : {10.0, 1e4, 1e6}) {
            CAPTURE(scene.name, distance);
            const Mechanism far = moved_rigidly(start, random.unit_p(), distance * Vec3(1.0, -2.0, 0.5));
            CHECK(std::abs(iterations(far) - usual) <= 1);
        }
    }
}
