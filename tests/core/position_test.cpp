#include <catch2/catch.hpp>

#include <cmath>

#include "core/poses/position.hpp"
#include "tests/support/scenes.hpp"

using namespace jw;
using test::kPi;
using test::radians;

namespace {

/// Body 1 on a joint of `type` with ground, assembled at a random place.
Mechanism pair_of(std::string_view type, unsigned seed) {
    test::Random random(seed);
    test::SceneBuilder scene;
    const int body = scene.add_body("body", random.vector());
    scene.add_joint(type, 0, body, random.vector(), random.direction());
    return scene.mechanism;
}

double cosine_of_axes(const Mechanism& mechanism, const State& state) {
    const JointGeometry& g = mechanism.joints[0].geometry;
    return (rotation_matrix(state.p[0]) * g.s_i_local).dot(rotation_matrix(state.p[1]) * g.s_j_local);
}

}  // namespace

TEMPLATE_TEST_CASE(
    "A revolute assembles with axes the same way from every misalignment, half turns included",
    "[core][position]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const double degrees =
        GENERATE(0.0, 30.0, 66.0, 67.0, 70.0, 80.0, 89.0, 90.0, 91.0, 100.0, 113.0, 150.0, 170.0, 180.0);
    const auto form = GENERATE(ParallelForm::rule, ParallelForm::all_three, ParallelForm::pair);
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(degrees, seed, static_cast<int>(form));
        Mechanism mechanism = pair_of("revolute", seed);
        mechanism.joints[0].parallel_form = form;
        const System system(mechanism, everything(mechanism));
        test::Random random(seed + 100);
        State state = start_state(mechanism);
        const Vec3 s_i = rotation_matrix(state.p[0]) * mechanism.joints[0].geometry.s_i_local;
        const Vec3 about = s_i.cross(random.direction()).normalized();
        state.p[1] = turned_global(state.p[1], radians(degrees) * about);
        const PositionOutcome outcome = solve_position<TestType>(system, state, 0.0);
        REQUIRE(outcome.ok());
        CHECK(outcome.newton.converged);
        // 1 - cos of an axis error of 1e-13
        CHECK(cosine_of_axes(mechanism, state) == Approx(1.0).epsilon(1e-14));
        if (degrees <= 66.0) { CHECK(outcome.branches_left == 0); }
        if (degrees == 180.0) { CHECK(outcome.branches_left >= 1); }
    }
}

TEST_CASE("An anti-parallel loop joint is found and left, and the observer is told", "[core][position]") {
    Mechanism mechanism = test::four_bar_at(0.7);
    // the rocker put in upside down
    mechanism.bodies[3].p =
        turned_global(mechanism.bodies[3].p, kPi * Vec3(std::cos(0.2), std::sin(0.2), 0.0));
    const System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    int branches = 0;
    int steps = 0;
    const PositionOutcome outcome =
        solve_position<OmegaLocal>(system, state, 0.0, [&](const PositionEvent& event, const State& at) {
            CHECK(at.r.size() == 4);
            if (const auto* wrong = std::get_if<WrongBranch>(&event)) {
                CHECK(wrong->kind == WrongBranch::Kind::anti_parallel);
                CHECK(wrong->measure < 0.0);
                ++branches;
            } else {
                ++steps;
            }
        });
    REQUIRE(outcome.ok());
    CHECK(branches == outcome.branches_left);
    CHECK(branches >= 1);
    CHECK(steps >= outcome.newton.iterations);
    CHECK_FALSE(find_wrong_branch(system, state, intended_sides(system)).has_value());
}

TEMPLATE_TEST_CASE(
    "A weld or prismatic joint that is half a turn off comes back to the side of its start",
    "[core][position]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const std::string_view type : {"fixed", "prismatic"}) {
        for (unsigned seed = 1; seed <= 10; ++seed) {
            CAPTURE(type, seed);
            const Mechanism mechanism = pair_of(type, seed);
            const System system(mechanism, everything(mechanism));
            State state = start_state(mechanism);
            const Vec3 s_i = rotation_matrix(state.p[0]) * mechanism.joints[0].geometry.s_i_local;
            const Vec4 right = state.p[1];
            state.p[1] = turned_global(state.p[1], kPi * s_i);
            const Vec3 arm = mechanism.joints[0].geometry.P_j_local;
            state.r[1] += rotation_matrix(right) * arm - rotation_matrix(state.p[1]) * arm;

            const PositionOutcome outcome = solve_position<TestType>(system, state, 0.0);
            REQUIRE(outcome.ok());
            CHECK(outcome.branches_left == 1);
            CHECK(turn_local_between(right, state.p[1]).norm() < 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE(
    "A screw whose θ is half a turn off keeps its turns and comes to its angle", "[core][position]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const Mechanism mechanism = test::screw(0.4, 0.25, ScrewAngleForm::rotation);
    const System system(mechanism, everything(mechanism));
    for (const double off : {kPi, -kPi, 2.0, -2.5}) {
        CAPTURE(off);
        State state = start_state(mechanism);
        state.theta[0] += off;
        const PositionOutcome outcome = solve_position<TestType>(system, state, 0.0);
        REQUIRE(outcome.ok());
        const double angle = relative_angle(mechanism.joints[0], state);
        CHECK(std::abs(std::remainder(state.theta[0] - angle, 2.0 * kPi)) < 1e-12);
        // the nut may also move along; only its advance and its angle must match
        CHECK(std::abs(Vec3(1.0, 2.0, 2.0).dot(state.r[1]) / 3.0 - 0.25 * state.theta[0]) < 1e-12);
    }
}

TEST_CASE("Leaving the wrong angle of a screw keeps the turns that were counted", "[core][position]") {
    const Mechanism mechanism = test::screw(0.4, 0.25, ScrewAngleForm::rotation);
    const System system(mechanism, everything(mechanism));
    const double turns = 6.0 * kPi;
    State state = start_state(mechanism);
    state.theta[0] += turns + kPi - 0.1;
    state.r[1] += 0.25 * (state.theta[0] - 0.4) * Vec3(1.0, 2.0, 2.0) / 3.0;
    const WrongBranch wrong{WrongBranch::Kind::screw_angle, 3, -1.0};
    REQUIRE(system.constraints()[3].role == Role::screw_angle);
    leave_branch(system, wrong, state);
    CHECK(state.theta[0] == Approx(0.4 + turns).epsilon(1e-14));
}

TEST_CASE("θ more than a turn off is a count of turns, not an error", "[core][position]") {
    const Mechanism mechanism = test::screw(0.4, 0.25, ScrewAngleForm::rotation);
    const System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    state.theta[0] += 6.0 * kPi;
    state.r[1] += 0.25 * 6.0 * kPi * Vec3(1.0, 2.0, 2.0) / 3.0;
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    CHECK(outcome.ok());
    CHECK(outcome.branches_left == 0);
    CHECK(state.theta[0] == Approx(0.4 + 6.0 * kPi).epsilon(1e-15));
}

TEMPLATE_TEST_CASE(
    "Loops assemble from starts that are well off", "[core][position]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& mechanism :
         {test::four_bar_at(0.7), test::bennett(1.1), test::rssr(0.7), test::double_cardan(0.4, 0.3),
          test::slider_crank(1.0, 3.0, 0.7)}) {
        const System system(mechanism, everything(mechanism));
        for (unsigned seed = 1; seed <= 20; ++seed) {
            CAPTURE(mechanism.joints.size(), mechanism.joints[1].type->name, seed);
            test::Random random(seed);
            // 0.2 m and up to 20 deg in each component
            State state = test::disturbed(mechanism, start_state(mechanism), random, 0.2, 0.35);
            const PositionOutcome outcome = solve_position<TestType>(system, state, 0.0);
            CHECK(outcome.ok());
        }
    }
}

TEST_CASE(
    "A loop up to a million times as small as one beside it closes as well as that", "[core][position]") {
    const double ratio = GENERATE(1.0, 1e-2, 1e-4, 1e-6);
    for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(ratio, seed);
        Mechanism both = test::bricard(1.2);
        const Mechanism small = scaled(test::bricard(1.2), ratio);
        const int bodies = static_cast<int>(both.bodies.size()) - 1;
        both.bodies.insert(both.bodies.end(), small.bodies.begin() + 1, small.bodies.end());
        // with a ground of its own: the frame that its joints are given in
        both.bodies.push_back(small.bodies.front());
        const int ground = static_cast<int>(both.bodies.size()) - 1;
        for (Joint joint : small.joints) {
            for (int* body : {&joint.body_i, &joint.body_j}) { *body = *body > 0 ? *body + bodies : ground; }
            both.joints.push_back(joint);
        }
        test::Random random(seed);
        State state = test::disturbed(both, start_state(both), random, 0.0, 0.05);
        for (std::size_t b = 1; b < state.r.size(); ++b) {
            const double size = static_cast<int>(b) > bodies ? ratio : 1.0;
            if (!both.bodies[b].fixed) { state.r[b] += random.vector(0.05 * size); }
        }
        const System system(both, everything(both));
        const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
        REQUIRE(outcome.ok());
        CHECK_FALSE(outcome.newton.at_floor);
        // a hundred times Newton's tolerance is where its floor begins
        CHECK(outcome.newton.residual < 1e-11);
    }
}
