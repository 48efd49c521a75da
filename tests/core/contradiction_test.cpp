#include <catch2/catch.hpp>

#include <cmath>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/position.hpp"
#include "tests/support/random_mechanisms.hpp"
#include "tests/support/scenes.hpp"

/// Contradictions are reported with who contradicts whom, and by how much.
using namespace jw;

namespace {

PositionOutcome outcome_of(const Mechanism& mechanism, double t = 0.0) {
    System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    system.choose_rows(state);
    return solve_position<ModifiedEulerParameters>(system, state, t);
}

const Contradiction& contradiction_of(const PositionOutcome& outcome) {
    REQUIRE_FALSE(outcome.ok());
    CHECK(outcome.failure->cause == FailureCause::cannot_close);
    REQUIRE(outcome.failure->contradiction.has_value());
    return *outcome.failure->contradiction;
}

/// A body on a hinge at the origin.
test::SceneBuilder one_hinge() {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::UnitX());
    scene.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

}  // namespace

TEST_CASE("A loop with one axis tilted cannot close, and the tilt is told", "[core][position]") {
    for (const double tilt : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
        for (std::size_t joint = 0; joint < 4; ++joint) {
            for (const unsigned seed : {1u, 2u, 3u}) {
                CAPTURE(tilt, joint, seed);
                test::Random random(seed);
                Mechanism mechanism = test::four_bar_at(1.0);
                JointGeometry& g = mechanism.joints[joint].geometry;
                Vec3& axis = seed % 2 == 0 ? g.s_i_local : g.s_j_local;
                const Vec3 across = axis.cross(random.vector()).normalized();
                axis = (std::cos(tilt) * axis.normalized() + std::sin(tilt) * across).eval();
                const PositionOutcome outcome = outcome_of(mechanism);
                if (tilt < 4e-7) {
                    // an error of the seventh digit, which four joints share: loops typed like that close
                    CHECK(outcome.ok());
                    continue;
                }
                const Contradiction& found = contradiction_of(outcome);
                CHECK(found.joints == std::vector{0, 1, 2, 3});
                CHECK(found.drivers.empty());
                // the last joint may have its points apart instead of its axes tilted: rods are 1 to 3 m long
                const bool axes = found.role == Role::axes_parallel;
                CHECK((axes || found.role == Role::same_point));
                CHECK(found.gap > 0.1 * tilt);
                CHECK(found.gap < (axes ? 1.001 : 3.0) * tilt);
            }
        }
    }
}

TEST_CASE("A gap is the same however far away a body starts", "[core][position]") {
    for (const double distance : {1.0, 1e2, 1e4, 1e6, 1e8}) {
        for (int body = 1; body <= 3; ++body) {
            CAPTURE(distance, body);
            Mechanism mechanism = test::four_bar_at(1.0, {1.0, 2.5, 2.0, 4.0});
            mechanism.joints[2].geometry.P_i_local *= 0.5 / 2.5;
            mechanism.bodies[static_cast<std::size_t>(body)].r += distance * Vec3(0.3, -0.8, 0.5);
            // joint by joint, as in a lesson: each pose is the start estimate for the next joint
            State state = start_state(mechanism);
            PositionOutcome outcome;
            for (int count = 1; count <= 4 && (count == 1 || outcome.ok()); ++count) {
                Selection some;
                for (int joint = 0; joint < count; ++joint) { some.joints.push_back(joint); }
                System system(mechanism, some);
                system.choose_rows(state);
                outcome = solve_position<ModifiedEulerParameters>(system, state, 0.0);
            }
            const Contradiction& found = contradiction_of(outcome);
            CHECK(found.role == Role::same_point);
            // crank, coupler and rocker in line reach 3.5 of 4
            CHECK(found.gap == Approx(0.5).epsilon(1e-3));
            CHECK(found.joints.back() == 3);
        }
    }
}

TEST_CASE("Drivers that ask one joint for two angles are both named, with both angles", "[core][position]") {
    test::SceneBuilder scene = one_hinge();
    test::drive_angle(scene.mechanism, 0, test::polynomial({0.1}));
    test::drive_angle(scene.mechanism, 0, test::polynomial({0.5}));
    const PositionOutcome outcome = outcome_of(scene.mechanism);
    const Contradiction& found = contradiction_of(outcome);
    CHECK(found.joints.empty());
    CHECK(found.drivers == std::vector{0, 1});
    CHECK(found.asked == 0.5);
    CHECK(found.found == Approx(0.1).epsilon(1e-3));
}

TEST_CASE("A driver that contradicts nobody is not named", "[core][position]") {
    test::SceneBuilder scene = one_hinge();
    const int second = scene.add_body("second", Vec3(2.0, 0.0, 0.0));
    scene.add_joint("revolute", 1, second, Vec3(1.5, 0.0, 0.0), Vec3::UnitZ());
    test::drive_angle(scene.mechanism, 0, test::polynomial({0.1}));
    test::drive_angle(scene.mechanism, 1, test::polynomial({0.2}));
    test::drive_angle(scene.mechanism, 1, test::polynomial({0.3}));
    const PositionOutcome outcome = outcome_of(scene.mechanism);
    CHECK(contradiction_of(outcome).drivers == std::vector{1, 2});
}

TEST_CASE("Drivers that diverge end the motion, and both are named", "[core][motion]") {
    // first, second or third derivatives differ
    const std::vector<double> one{0.1, 1.0, 0.3, 0.0};
    for (std::size_t order = 1; order < one.size(); ++order) {
        CAPTURE(order);
        std::vector<double> other = one;
        other[order] += 0.2;
        test::SceneBuilder scene = one_hinge();
        test::drive_angle(scene.mechanism, 0, test::polynomial(one));
        test::drive_angle(scene.mechanism, 0, test::polynomial(other));
        System system(scene.mechanism, everything(scene.mechanism));
        State state = start_state(scene.mechanism);
        REQUIRE(solve_position<OmegaLocal>(system, state, 0.0).ok());
        MotionTracker tracker(system, state, 0.0);
        REQUIRE_FALSE(tracker.advance_to(0.5));
        const PositionFailure& failure = *tracker.failure();
        REQUIRE(failure.contradiction.has_value());
        CHECK(failure.contradiction->drivers == std::vector{0, 1});
        const double apart = 0.2 * std::pow(failure.t, static_cast<double>(order));
        CHECK(failure.contradiction->gap == Approx(apart).epsilon(1e-3));
    }
}

TEST_CASE("A driver beyond reach is named with what can be reached", "[core][position]") {
    test::SceneBuilder scene = one_hinge();
    Driver pull;
    pull.name = "pull";
    pull.measure = CoordinateMeasure{0};
    pull.body_j = 1;
    pull.function = test::polynomial({1.5});
    scene.mechanism.drivers.push_back(pull);
    const PositionOutcome outcome = outcome_of(scene.mechanism);
    const Contradiction& found = contradiction_of(outcome);
    CHECK(found.drivers == std::vector{0});
    CHECK(found.asked == 1.5);
    CHECK(found.found == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("A nut closes however far its thread begins", "[core][position]") {
    for (const double d_0 : {1.0, -1e2, 1e4, -1e5, 1e6}) {
        CAPTURE(d_0);
        test::SceneBuilder scene;
        const int nut = scene.add_body("nut", Vec3(0.1, 0.0, 0.2));
        Joint& screw = scene.add_joint("screw", 0, nut, Vec3::Zero(), Vec3::UnitZ());
        screw.geometry.alpha = 0.02;
        screw.geometry.d_0 = d_0;
        const System system(scene.mechanism, everything(scene.mechanism));
        State state = start_state(scene.mechanism);
        const PositionOutcome outcome = solve_position<ModifiedEulerParameters>(system, state, 0.0);
        REQUIRE(outcome.ok());
        // rounding of 1e6 m
        CHECK(outcome.newton.residual < 1e-9 * std::max(1.0, std::abs(d_0)));
    }
}
