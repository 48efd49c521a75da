#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/position.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/grown_mechanisms.hpp"

using namespace jw;
using test::kPi;

namespace {

std::vector<Mechanism> driven_scenes() {
    return {
        test::driven(test::four_bar_at(0.7), 0, 1.3, 0.4),
        test::driven(test::slider_crank(1.0, 3.0, 0.7), 0, 1.3, 0.4),
        test::driven(test::bennett(0.7), 0, 1.3, 0.4),
        test::driven(test::cardan(0.6, 0.3), 0, 1.3, 0.4),
        test::driven(test::double_cardan(0.4, 0.3), 0, 1.3, 0.4),
        test::driven(test::screw(0.7, 0.25, ScrewAngleForm::rotation), 0, 1.3, 0.4)};
}

}  // namespace

TEST_CASE("Velocities and accelerations are the same in all four coordinate choices", "[core][kinematics]") {
    for (const Mechanism& mechanism : driven_scenes()) {
        CAPTURE(mechanism.joints[1 % mechanism.joints.size()].type->name, mechanism.joints.size());
        const State state = start_state(mechanism);
        const test::Analysis local = test::analyse<OmegaLocal>(mechanism, state);
        CHECK(local.velocity.verdict.unique);
        CHECK(local.acceleration.verdict.consistent);
        for (const test::Analysis& other :
             {test::analyse<OmegaGlobal>(mechanism, state),
              test::analyse<TrueEulerParameters>(mechanism, state),
              test::analyse<ModifiedEulerParameters>(mechanism, state)}) {
            CHECK(other.velocity.verdict.unique);
            CHECK(other.velocity.verdict.consistent);
            // conditions up to 30 times rounding, on numbers up to 5
            CHECK(test::difference(local.velocity.velocity, other.velocity.velocity) < 1e-12);
            CHECK(
                test::difference(local.acceleration.acceleration, other.acceleration.acceleration) <
                1e-12 * 10.0);
        }
    }
}

TEST_CASE(
    "Velocities and accelerations are those of central differences of positions", "[core][kinematics]") {
    for (const Mechanism& mechanism : driven_scenes()) {
        CAPTURE(mechanism.joints[1 % mechanism.joints.size()].type->name, mechanism.joints.size());
        const System system(mechanism, everything(mechanism));
        const auto at = [&](double t) {
            State state = start_state(mechanism);
            REQUIRE(solve_position<OmegaLocal>(system, state, t).ok());
            return state;
        };
        // order 4: truncation h⁴/90 times sixth derivatives, which reach 1e6 in Bennett, leaves 1e-8 in r̈;
        // rounding 5e-15 / h² as much
        const double h = 1e-3;
        const State now = at(0.0);
        const State one = at(h);
        const State back = at(-h);
        const State two = at(2.0 * h);
        const State back_two = at(-2.0 * h);
        const test::Analysis analysis = test::analyse(mechanism, now);
        for (const int b : system.moving_bodies()) {
            const auto k = static_cast<std::size_t>(b);
            const Vec3 r_dot = (8.0 * (one.r[k] - back.r[k]) - (two.r[k] - back_two.r[k])) / (12.0 * h);
            const Vec3 r_ddot =
                (16.0 * (one.r[k] + back.r[k]) - (two.r[k] + back_two.r[k]) - 30.0 * now.r[k]) /
                (12.0 * h * h);
            const Vec4 p_dot = (8.0 * (one.p[k] - back.p[k]) - (two.p[k] - back_two.p[k])) / (12.0 * h);
            const Vec4 p_ddot =
                (16.0 * (one.p[k] + back.p[k]) - (two.p[k] + back_two.p[k]) - 30.0 * now.p[k]) /
                (12.0 * h * h);
            CHECK((analysis.velocity.velocity.r_dot[k] - r_dot).norm() < 1e-8);
            CHECK(
                (analysis.velocity.velocity.omega_local[k] - omega_local_of(now.p[k], p_dot)).norm() < 1e-8);
            CHECK((analysis.acceleration.acceleration.r_dot[k] - r_ddot).norm() < 1e-7);
            CHECK(
                (analysis.acceleration.acceleration.omega_local[k] - omega_local_dot_of(now.p[k], p_ddot))
                    .norm() < 1e-7);
        }
    }
}

TEMPLATE_TEST_CASE(
    "Under-driven: the shortest velocity that satisfies the rows, and not unique is said",
    "[core][kinematics]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    // two freedoms, one driver
    const Mechanism mechanism = test::driven(test::rssr(0.7), 0, 1.3);
    const System system(mechanism, everything(mechanism));
    const State state = start_state(mechanism);
    const test::Analysis analysis = test::analyse<TestType>(mechanism, state);
    CHECK_FALSE(analysis.velocity.verdict.unique);
    CHECK(analysis.velocity.verdict.consistent);
    CHECK(analysis.velocity.verdict.rank == 17 + (TestType::kNormalised ? 3 : 0));

    Assembler<TestType> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    assembler.assemble_nu(0.0);
    const VectorX x = assembler.layout().columns_of(state, analysis.velocity.velocity);
    // rounding
    CHECK((assembler.jacobian() * x - assembler.nu()).cwiseAbs().maxCoeff() < 1e-13);
    // the solution of least norm has no part along the free motion, which is the rod's spin about itself
    const test::Rssr l;
    const Vec3 rod = (l.rocker_end(l.psi(0.7)) - l.crank_end(0.7)).normalized();
    Motion spin = zero_motion(mechanism);
    // the rod turns about a line through its middle, where its origin is
    spin.omega_local[2] = rotation_matrix(state.p[2]).transpose() * rod;
    const VectorX free = assembler.layout().columns_of(state, spin);
    CHECK((assembler.jacobian() * free).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(std::abs(free.dot(x)) < 1e-13);
}

TEST_CASE("Undriven and at rest in the reference: nothing moves", "[core][kinematics]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const test::Analysis analysis = test::analyse(mechanism, start_state(mechanism));
    CHECK_FALSE(analysis.velocity.verdict.unique);
    CHECK(analysis.velocity.verdict.consistent);
    CHECK(analysis.velocity.verdict.rank == 17);
    CHECK(test::difference(analysis.velocity.velocity, zero_motion(mechanism)) == 0.0);
}

TEST_CASE(
    "The velocity nearest to a reference is the reference itself where that is possible",
    "[core][kinematics]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    Kinematics<OmegaLocal> kinematics(system);
    kinematics.set_state(start_state(mechanism), 0.0);
    const Motion possible =
        test::analyse(test::driven(mechanism, 0, 1.0), start_state(mechanism)).velocity.velocity;
    CHECK(test::difference(kinematics.solve_velocity(possible).velocity, possible) < 1e-13);
    Motion impossible = possible;
    impossible.r_dot[2] += Vec3(0.3, -0.2, 0.5);
    const VelocityOutcome nearest = kinematics.solve_velocity(impossible);
    CHECK(nearest.verdict.consistent);
    CHECK(test::difference(nearest.velocity, impossible) > 0.1);
}

TEST_CASE(
    "Two drivers that contradict each other are reported, with a row and the size", "[core][kinematics]") {
    Mechanism mechanism = test::driven(test::four_bar_at(0.7), 0, 1.0);
    test::drive_angle(mechanism, 0, test::polynomial({0.7, 3.0}));
    const System system(mechanism, everything(mechanism));
    const test::Analysis analysis = test::analyse(mechanism, start_state(mechanism));
    const LinearVerdict& verdict = analysis.velocity.verdict;
    CHECK_FALSE(verdict.consistent);
    CHECK(verdict.rank == 18);
    CHECK(verdict.unique);
    CHECK(system.origin(verdict.worst_row).kind == RowOrigin::Kind::driver);
    // least squares meet in the middle, at rate 2, up to the residuals of the joints; relative to the largest
    // of the right side, 3
    CHECK(verdict.residual > 0.25);
    CHECK(verdict.residual < 1.0 / 3.0 + 1e-12);
    // the accelerations of both drivers are 0, but γ of the joints is not contradicted by them
    CHECK(analysis.acceleration.verdict.rank == 18);
}

TEST_CASE("Two drivers that agree are redundant, not inconsistent", "[core][kinematics]") {
    Mechanism mechanism = test::driven(test::four_bar_at(0.7), 0, 1.0, 0.5);
    mechanism.drivers.push_back(mechanism.drivers[0]);
    const test::Analysis analysis = test::analyse(mechanism, start_state(mechanism));
    CHECK(analysis.velocity.verdict.consistent);
    CHECK(analysis.acceleration.verdict.consistent);
    CHECK(analysis.velocity.verdict.unique);
    CHECK(
        test::joint_angle(mechanism, 0, start_state(mechanism), analysis).rate == Approx(1.0).epsilon(1e-13));
    CHECK(
        test::joint_angle(mechanism, 0, start_state(mechanism), analysis).acceleration ==
        Approx(0.5).epsilon(1e-12));
}

TEST_CASE("Every kind of driver drives its measure as its function says", "[core][kinematics]") {
    TimeFunction function;
    function.polynomial = {0.9, 0.3};
    function.harmonics = {{0.05, 2.0, 0.0}};
    const double t = 0.2;
    const TimeFunction::Value target = function.at(t);
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3(0.3, 0.2, 0.1));
    const Vec3 axis(2.0, -1.0, 2.0);
    const auto check = [&](std::string_view type, const auto& measure_of, double value, double rate,
                           double acceleration) {
        CAPTURE(type);
        Mechanism mechanism = scene.mechanism;
        test::SceneBuilder with = scene;
        const Joint& joint = with.add_joint(type, 0, body, Vec3(0.5, 0.5, 0.0), axis);
        mechanism = with.mechanism;
        const Measure measure = measure_of(joint);
        mechanism.drivers.push_back({"driver", 0, 0, body, measure, function});
        const System system(mechanism, everything(mechanism));
        State state = start_state(mechanism);
        REQUIRE(solve_position<OmegaLocal>(system, state, t).ok());
        const test::Analysis analysis = test::analyse(mechanism, state, t);
        const Measured measured = evaluate_measure(
            measure, 0, body, -1, state, analysis.velocity.velocity, analysis.acceleration.acceleration);
        CHECK(measured.value == Approx(value).epsilon(1e-12));
        CHECK(measured.rate == Approx(rate).epsilon(1e-12));
        CHECK(measured.acceleration == Approx(acceleration).epsilon(1e-11));
    };
    const double f = target.f;
    const double f_1 = target.f_dot;
    const double f_2 = target.f_ddot;
    for (const std::string_view type : {"revolute", "cylindrical"}) {
        check(
            type, [](const Joint& j) { return Measure(angle_of(j)); }, f, f_1, f_2);
    }
    for (const std::string_view type : {"prismatic", "cylindrical"}) {
        check(
            type, [](const Joint& j) { return Measure(displacement_of(j)); }, f, f_1, f_2);
    }
    const auto distance = [&](const Joint&) {
        return Measure(SquaredDistanceMeasure{Vec3(0.1, 0.2, 0.3), Vec3(0.2, -0.3, 0.1)});
    };
    check("prismatic", distance, f * f, 2.0 * f * f_1, 2.0 * (f_1 * f_1 + f * f_2));
    check(
        "cylindrical", [](const Joint&) { return Measure(CoordinateMeasure{0}); }, f, f_1, f_2);
}

TEST_CASE("A row of driven links is followed with a proof", "[core][kinematics]") {
    for (const int n : {5, 10, 15}) {
        CAPTURE(n);
        Mechanism mechanism = test::hinge_chain(n);
        const auto rate = [](int k) { return k % 3 == 0 ? 0.5 : -0.3; };
        for (int k = 0; k < n; ++k) { test::drive_angle(mechanism, k, test::polynomial({0.0, rate(k)})); }
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        REQUIRE(tracker.advance_to(1.0));
        CHECK(tracker.crossings().empty());
        Vec3 end = Vec3::Zero();
        double turn = 0.0;
        double off = 0.0;
        for (int k = 0; k < n; ++k) {
            turn += rate(k);
            const Vec3 along(std::cos(turn), 0.0, std::sin(turn));
            off = std::max(off, (tracker.frame().state.r[at(k + 1)] - (end + 0.5 * along)).norm());
            end += along;
        }
        // Newton's method ends at 1e-13 of the size of the row; each hinge passes on what the others are off
        CHECK(off < 1e-13 * n * n);
    }
}
