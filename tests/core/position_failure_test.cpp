#include <catch2/catch.hpp>

#include <cmath>

#include "core/poses/position.hpp"
#include "tests/support/scenes.hpp"

/// Positions that cannot be found: the state stays unchanged, and the failure names the cause.
using namespace jw;
using test::radians;

namespace {

bool same(const State& a, const State& b) { return a.r == b.r && a.p == b.p && a.theta == b.theta; }

/// Four-bar with a coupler that is made too short after assembly: 0.5 between points that stay 1 apart.
Mechanism short_coupler() {
    Mechanism mechanism = test::four_bar_at(1.0, {1.0, 2.5, 2.0, 4.0});
    JointGeometry& g = mechanism.joints[2].geometry;
    g.P_i_local *= 0.5 / 2.5;  // the coupler's origin is at its other end
    return mechanism;
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Rods that are too short: cannot close, with the gap at the closest fit", "[core][position]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const Mechanism mechanism = short_coupler();
    const System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    const State before = state;
    const PositionOutcome outcome = solve_position<TestType>(system, state, 0.0);
    REQUIRE_FALSE(outcome.ok());
    CHECK_FALSE(outcome.newton.converged);
    const PositionFailure& failure = *outcome.failure;
    CHECK(failure.cause == FailureCause::cannot_close);
    CHECK(same(state, before));
    // crank, coupler and rocker in line reach 3.5 of 4; four joints share the gap of 0.5
    CHECK(std::abs(failure.value) == Approx(0.5 / 4.0).epsilon(1e-3));
    CHECK(failure.residual == Approx(std::abs(failure.value)).epsilon(1e-12));  // the scene's unit is 1 m
    const RowOrigin origin = system.origin(failure.row);
    REQUIRE(origin.kind == RowOrigin::Kind::constraint);
    const Constraint& c = system.constraints()[static_cast<std::size_t>(origin.index)];
    CHECK(c.role == Role::same_point);
    CHECK(origin.component == 0);  // the gap is along the ground
    CHECK(failure.iterations > 0);
    CHECK_FALSE(failure.branch.has_value());
}

TEST_CASE(
    "Drivers that contradict each other cannot close, and a driver's row is named", "[core][position]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_joint("revolute", 0, body, Vec3::UnitX(), Vec3::UnitZ());
    test::drive_angle(scene.mechanism, 0, test::polynomial({0.1}));
    test::drive_angle(scene.mechanism, 0, test::polynomial({0.5}));
    const System system(scene.mechanism, everything(scene.mechanism));
    State state = start_state(scene.mechanism);
    const State before = state;
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    REQUIRE_FALSE(outcome.ok());
    CHECK(outcome.failure->cause == FailureCause::cannot_close);
    CHECK(system.origin(outcome.failure->row).kind == RowOrigin::Kind::driver);
    // the fit is in the middle
    CHECK(std::abs(outcome.failure->value) == Approx(0.2).epsilon(1e-3));
    CHECK(same(state, before));
}

TEST_CASE("A start with parallel arms of a universal joint is singular, not impossible", "[core][position]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_universal(0, body, Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitX());
    const System system(scene.mechanism, everything(scene.mechanism));
    State state = start_state(scene.mechanism);
    const State before = state;
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    REQUIRE_FALSE(outcome.ok());
    CHECK(outcome.failure->cause == FailureCause::singular);
    CHECK(same(state, before));
    const RowOrigin origin = system.origin(outcome.failure->row);
    CHECK(system.constraints()[static_cast<std::size_t>(origin.index)].role == Role::axes_perpendicular);
    CHECK(outcome.failure->value == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("A rod whose ends start at the same point is singular, not impossible", "[core][position]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_distance(0, body, Vec3::UnitX(), Vec3::UnitX()).geometry.length = 1.0;
    const System system(scene.mechanism, everything(scene.mechanism));
    State state = start_state(scene.mechanism);
    // the frames of the scene leave rounding: exactly on the point
    const JointGeometry& g = scene.mechanism.joints[0].geometry;
    state.p[1] = state.p[0];
    state.r[1] = state.r[0];
    scene.mechanism.joints[0].geometry.P_j_local = g.P_i_local;
    const System exact(scene.mechanism, everything(scene.mechanism));
    const PositionOutcome outcome = solve_position<OmegaLocal>(exact, state, 0.0);
    REQUIRE_FALSE(outcome.ok());
    CHECK(outcome.failure->cause == FailureCause::singular);
    CHECK(outcome.failure->value == Approx(-1.0).epsilon(1e-12));
}

TEST_CASE(
    "A body that can only sit anti-parallel fails as a wrong branch and says at which joint",
    "[core][position]") {
    // the two axes on the ground have opposite directions, those on the body the same direction
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_joint("p1", 0, body, Vec3::Zero(), Vec3::UnitZ());
    Joint& second = scene.add_joint("p1", 0, body, Vec3::Zero(), Vec3::UnitZ());
    second.geometry.s_i_local *= -1.0;
    const System system(scene.mechanism, everything(scene.mechanism));
    State state = start_state(scene.mechanism);
    const State before = state;
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    REQUIRE_FALSE(outcome.ok());
    CHECK(outcome.failure->cause == FailureCause::wrong_branch);
    REQUIRE(outcome.failure->branch.has_value());
    CHECK(outcome.failure->branch->kind == WrongBranch::Kind::anti_parallel);
    CHECK(outcome.failure->branch->measure == Approx(-1.0).epsilon(1e-12));
    CHECK(outcome.newton.converged);
    CHECK(same(state, before));
}
