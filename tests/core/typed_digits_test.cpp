#include <catch2/catch.hpp>

#include <cmath>

#include "core/poses/position.hpp"
#include "tests/support/driven.hpp"

/// Lessons that are typed with few digits: loops that close only approximately must still move.
using namespace jw;

namespace {

/// Points and axes off by up to `error`, as if they had been rounded there.
Mechanism rounded(Mechanism mechanism, double error) {
    test::Random random(3);
    for (Joint& joint : mechanism.joints) {
        JointGeometry& g = joint.geometry;
        for (Vec3* v : {&g.P_i_local, &g.P_j_local, &g.s_i_local, &g.s_j_local}) {
            *v += random.vector(error);
        }
    }
    return mechanism;
}

State assembled(const Mechanism& mechanism, double error) {
    const System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    REQUIRE(outcome.ok());
    CHECK(outcome.newton.residual < 2.0 * error);
    // more than a hundred roundings are left, and the outcome reports it
    CHECK(outcome.newton.at_floor == (error > 1e-11));
    return state;
}

}  // namespace

TEST_CASE("A loop that closes to the typed digits has the rank of the exact one", "[core][typed_digits]") {
    for (const double error : {1e-12, 1e-10, 1e-8, 1e-7}) {
        CAPTURE(error);
        const Mechanism mechanism = rounded(test::bennett(0.7), error);
        const State state = assembled(mechanism, error);
        const System system(mechanism, everything(mechanism));
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(state, 0.0);
        CHECK(analyse_rank(system, assembler.jacobian(), assembler.phi()).rank == 17);
    }
}

TEST_CASE("A loop that closes to the typed digits can be driven over a turn", "[core][typed_digits]") {
    for (const double error : {1e-12, 1e-10, 1e-8, 1e-7}) {
        CAPTURE(error);
        const Mechanism mechanism = rounded(test::driven(test::bennett(0.7), 0, 1.0), error);
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, assembled(mechanism, error), 0.0);
        const double constant = test::Bennett{}.half_tangents();
        for (int k = 1; k <= 70; ++k) {
            REQUIRE(tracker.advance_to(0.1 * k));
            const MotionFrame& frame = tracker.frame();
            CHECK(frame.velocity_verdict.unique);
            CHECK(frame.velocity_verdict.consistent);
            CHECK(frame.acceleration_verdict.consistent);
            CHECK_FALSE(frame.change_point);
            const double half = 0.5 * (0.7 + 0.1 * k);
            const double next = 0.5 * test::joint_angle(mechanism, 1, frame).value;
            const double miss = std::sin(half) * std::sin(next) - constant * std::cos(half) * std::cos(next);
            // the error over the smallest singular value, and 4 for the linkage's own sensitivity
            CHECK(std::abs(miss) < 20.0 * error);
        }
    }
}

TEST_CASE("A free loop that closes to the typed digits keeps its freedom", "[core][typed_digits]") {
    for (const double error : {1e-12, 1e-10, 1e-8, 1e-7}) {
        CAPTURE(error);
        const Mechanism exact = test::bennett(0.7);
        const Motion possible =
            test::analyse(test::driven(exact, 0, 1.0), start_state(exact)).velocity.velocity;

        const Mechanism mechanism = rounded(exact, error);
        const System system(mechanism, everything(mechanism));
        Kinematics<OmegaLocal> kinematics(system);
        kinematics.set_state(assembled(mechanism, error), 0.0);
        CHECK(kinematics.rank() == 17);
        const VelocityOutcome velocity = kinematics.solve_velocity(possible);
        CHECK_FALSE(velocity.verdict.unique);
        // the velocity of the exact linkage is nearly a velocity of this one: the error over 0.4, twice
        CHECK(test::difference(velocity.velocity, possible) < 50.0 * error);
    }
}

TEMPLATE_TEST_CASE(
    "Newton leaves a free loop where it is when it can close to the typed digits only",
    "[core][typed_digits]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const double error : {1e-12, 1e-10, 1e-9, 1e-8, 3e-8}) {
        for (const Mechanism& exact :
             {test::bennett(0.7), test::bricard(1.2), test::four_bar_at(0.7),
              test::slider_crank(1.0, 3.0, 0.7)}) {
            CAPTURE(error, exact.joints.size(), exact.joints.back().type->name);
            const Mechanism mechanism = rounded(exact, error);
            const System system(mechanism, everything(mechanism));
            NewtonStepper<TestType> stepper(system);
            stepper.start(start_state(mechanism), 0.0);
            const NewtonOutcome outcome = solve(stepper);
            CHECK(outcome.converged);
            CHECK(outcome.iterations <= 4);
            for (std::size_t b = 0; b < exact.bodies.size(); ++b) {
                // residuals of a few times the error over singular values down to 0.25
                CHECK((stepper.state().r[b] - exact.bodies[b].r).norm() < 30.0 * error);
                CHECK(turn_local_between(stepper.state().p[b], exact.bodies[b].p).norm() < 30.0 * error);
            }
        }
    }
}

TEST_CASE(
    "A loop that misses by more than seven digits cannot close, and the gap is told",
    "[core][typed_digits]") {
    for (const double error : {1e-6, 1e-5, 1e-4, 1e-3}) {
        for (const Mechanism& exact : {test::bennett(0.7), test::four_bar_at(0.7)}) {
            CAPTURE(error, exact.joints.size());
            const Mechanism mechanism = rounded(exact, error);
            const System system(mechanism, everything(mechanism));
            State state = start_state(mechanism);
            const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
            REQUIRE_FALSE(outcome.ok());
            CHECK(outcome.failure->cause == FailureCause::cannot_close);
            // the fit distributes the misfit over the joints
            CHECK(std::abs(outcome.failure->value) > 0.03 * error);
            CHECK(std::abs(outcome.failure->value) < error);
        }
    }
}
