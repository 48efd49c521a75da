#include "core/kinematics/kinematic_residuals.hpp"

#include <catch2/catch.hpp>

#include "core/kinematics/kinematics.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_nets.hpp"

using namespace jw;

namespace {

double largest_scaled(const VectorX& misses, const System& system) {
    double largest = 0.0;
    for (int row = 0; row < system.rows(); ++row) {
        largest = std::max(largest, std::abs(misses(row)) / system.row_unit(row));
    }
    return largest;
}

}  // namespace

TEST_CASE("What velocities and accelerations miss is Φq q̇ − ν and Φq q̈ − γ", "[core][residuals]") {
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = test::random_net(random);
        const System system(mechanism, everything(mechanism));
        const State state = start_state(mechanism);
        Assembler<OmegaLocal> assembler(system);
        const auto any = [&] {
            VectorX columns(assembler.layout().columns());
            for (double& x : columns) { x = random.number(); }
            return columns;
        };
        const VectorX q_dot = any();
        const VectorX q_ddot = any();
        const Motion velocity = assembler.layout().motion_of(state, q_dot);
        const KinematicResiduals found =
            residuals_of(system, state, velocity, assembler.layout().acceleration_of(state, q_ddot), 0.3);
        assembler.assemble_phi_and_jacobian(state, 0.3);
        assembler.assemble_nu(0.3);
        assembler.assemble_gamma(state, velocity, 0.3);
        const MatrixX& J = assembler.jacobian();
        // rounding of rows of size 1, at coordinates up to 1e3 scene units
        const auto near = [](double value) { return Approx(value).epsilon(1e-11).margin(1e-11); };
        CHECK(found.position.residual == near(largest_scaled(assembler.phi(), system)));
        CHECK(found.velocity.residual == near(largest_scaled(J * q_dot - assembler.nu(), system)));
        CHECK(found.acceleration.residual == near(largest_scaled(J * q_ddot - assembler.gamma(), system)));
    }
}

TEST_CASE(
    "Every frame of a driven motion keeps to its bounds, and a wrong one does not", "[core][residuals]") {
    for (const Mechanism& mechanism :
         {test::driven(test::four_bar_at(0.7), 0, 1.3, 0.4),
          test::driven(test::slider_crank(1.0, 3.0, 0.7), 0, 1.3, 0.4),
          test::driven(test::bennett(0.7), 0, 1.3, 0.4), test::driven(test::cardan(0.6, 0.3), 0, 1.3, 0.4),
          test::driven(test::screw(0.7, 0.25, ScrewAngleForm::rotation), 0, 1.3, 0.4)}) {
        CAPTURE(mechanism.joints.size(), mechanism.joints.back().type->name);
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        for (int k = 1; k <= 20; ++k) {
            const double t = 0.05 * k;
            REQUIRE(tracker.advance_to(t));
            const MotionFrame& frame = tracker.frame();
            const KinematicResiduals right =
                residuals_of(system, frame.state, frame.velocity, frame.acceleration, t);
            CAPTURE(t, right.position.residual, right.velocity.residual, right.acceleration.residual);
            CHECK(right.position.holds());
            CHECK(right.velocity.holds());
            CHECK(right.acceleration.holds());

            // wrong by a millionth: a hundred thousand times the bound
            State moved = frame.state;
            Motion velocity = frame.velocity;
            Motion acceleration = frame.acceleration;
            const auto body = static_cast<std::size_t>(system.moving_bodies().front());
            moved.r[body] += Vec3(1e-6, 2e-6, 3e-6);
            velocity.r_dot[body] += Vec3(1e-6, 2e-6, 3e-6);
            acceleration.r_dot[body] += Vec3(1e-6, 2e-6, 3e-6);
            CHECK_FALSE(residuals_of(system, moved, frame.velocity, frame.acceleration, t).position.holds());
            CHECK_FALSE(residuals_of(system, frame.state, velocity, frame.acceleration, t).velocity.holds());
            CHECK_FALSE(
                residuals_of(system, frame.state, frame.velocity, acceleration, t).acceleration.holds());
        }
    }
}
