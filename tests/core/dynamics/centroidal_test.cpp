#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "tests/support/moved_along.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

constexpr double kRounding = 1e-14;  // numbers below 10, some ten operations

/// A screw, and drivers of every measure except the place of a body, which is that of its origin.
Mechanism with_drivers(test::Random& random) {
    Mechanism mechanism = test::random_drivers(random);
    std::erase_if(mechanism.drivers, [](const Driver& d) {
        const auto* c = std::get_if<CoordinateMeasure>(&d.measure);
        return c != nullptr && c->coordinate < 3;
    });
    return mechanism;
}

VectorX phi_of(const Mechanism& mechanism, const State& state) {
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.3);
    return assembler.phi();
}

void check_that_constraints_stay(test::Random& random, const Mechanism& mechanism) {
    const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
    const State start = start_state(mechanism);
    const State moved = scene.to_centroidal(start);
    CHECK((phi_of(scene.mechanism, moved) - phi_of(mechanism, start)).norm() < kRounding);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        CHECK((scene.mechanism.bodies[b].r - moved.r[b]).norm() == 0.0);
        const Motion motion = scene.to_centroidal(start, start_motion(mechanism));
        CHECK((scene.mechanism.bodies[b].r_dot - motion.r_dot[b]).norm() == 0.0);
    }
}

}  // namespace

TEST_CASE("Constraints hold as before when frames move to the centres of mass", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        for (const JointType& type : kJointTypes) {
            CAPTURE(type.name);
            check_that_constraints_stay(
                random, test::random_joint(random, type, ParallelForm::rule, ScrewAngleForm::rotation));
        }
        check_that_constraints_stay(random, with_drivers(random));
    }
}

TEST_CASE("Forces and springs keep their points in space when frames move", "[core][dynamics]") {
    test::Random random(2);
    const Mechanism mechanism = test::random_joint(
        random, *find_joint_type("revolute"), ParallelForm::rule, ScrewAngleForm::rotation);
    const Loads loads = test::random_loads(random, mechanism);
    const Centroidal scene = centroidal(mechanism, loads);
    const auto distance = [&](int body, const Vec3& given, const Vec3& moved) {
        const auto b = static_cast<std::size_t>(body);
        const auto place = [&](const Mechanism& m, const Vec3& P) -> Vec3 {
            return m.bodies[b].r + rotation_matrix(m.bodies[b].p) * P;
        };
        return (place(mechanism, given) - place(scene.mechanism, moved)).norm();
    };
    REQUIRE(loads.forces.size() + loads.springs.size() > 4);
    for (std::size_t k = 0; k < loads.forces.size(); ++k) {
        const AppliedForce& given = loads.forces[k];
        CHECK(distance(given.body, given.point_local, scene.loads.forces[k].point_local) < kRounding);
    }
    for (std::size_t k = 0; k < loads.springs.size(); ++k) {
        const Spring& given = loads.springs[k];
        const Spring& moved = scene.loads.springs[k];
        CHECK(distance(given.body_i, given.P_i_local, moved.P_i_local) < kRounding);
        CHECK(distance(given.body_j, given.P_j_local, moved.P_j_local) < kRounding);
    }
}

TEST_CASE("Centres of mass move as their bodies do, and back", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        Mechanism mechanism;
        mechanism.bodies = {test::random_body(random, "i"), test::random_body(random, "j")};
        const Loads loads = test::random_loads(random, mechanism);
        const Centroidal scene = centroidal(mechanism, loads);
        const State state = start_state(mechanism);
        const Motion velocity = start_motion(mechanism);
        Motion acceleration = zero_motion(mechanism);
        for (Vec3& r_ddot : acceleration.r_dot) { r_ddot = random.vector(); }
        for (Vec3& omega_dot : acceleration.omega_local) { omega_dot = random.vector(); }

        const State moved = scene.to_centroidal(state);
        const Motion moved_velocity = scene.to_centroidal(state, velocity);
        const State back = scene.as_given(moved);
        const Motion velocity_back = scene.as_given(moved, moved_velocity);
        const Motion as_given = scene.acceleration_as_given(moved, moved_velocity, acceleration);
        for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
            CAPTURE(seed, b);
            const Vec3 centre = rotation_matrix(state.p[b]) * loads.masses[b]->centre_local;
            CHECK((moved.r[b] - state.r[b] - centre).norm() < kRounding);
            CHECK((back.r[b] - state.r[b]).norm() < kRounding);
            CHECK((velocity_back.r_dot[b] - velocity.r_dot[b]).norm() < kRounding);
            const auto centre_at = [&](double t) -> Vec3 {
                return scene.to_centroidal(test::moved_along(state, velocity, acceleration, t)).r[b];
            };
            const auto origin_at = [&](double t) -> Vec3 {
                return scene.as_given(test::moved_along(moved, moved_velocity, acceleration, t)).r[b];
            };
            CHECK((moved_velocity.r_dot[b] - test::rate_by_difference(centre_at)).norm() < test::kRateError);
            CHECK(
                (as_given.r_dot[b] - test::acceleration_by_difference(origin_at)).norm() <
                test::kAccelerationError);
        }
    }
}
