#include <catch2/catch.hpp>

#include <cmath>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/scenes.hpp"

using namespace jw;
using test::kPi;
using test::radians;

namespace {

constexpr double kAlpha = 0.25;

struct Verdict {
    int rank;
    double smallest;
    double condition;
};

/// 6 x 7 matrix of a nut on a spindle along z.
Verdict verdict_at(double theta, ScrewAngleForm form) {
    const RankReport report = test::rank_of(test::screw(theta, kAlpha, form, Vec3::UnitZ()));
    REQUIRE(report.rows == 6);
    REQUIRE(report.columns == 7);
    return {report.rank, report.singular_values(5), report.singular_values(0) / report.singular_values(5)};
}

}  // namespace

TEST_CASE("The rotation row keeps singular value 1 and condition 1.44 at every angle", "[core][screw]") {
    for (double degrees = -360.0; degrees <= 1080.0; degrees += 15.0) {
        CAPTURE(degrees);
        const Verdict verdict = verdict_at(radians(degrees), ScrewAngleForm::rotation);
        CHECK(verdict.rank == 6);
        CHECK(verdict.smallest == Approx(1.0).epsilon(1e-13));
        // closed form for a nut on a fixed spindle; 1.44 for this α
        CHECK(verdict.condition == Approx(std::sqrt(2.0 + kAlpha * kAlpha)).epsilon(1e-13));
    }
}

TEST_CASE("The cos row loses its singular value with sin θ, as tabled", "[core][screw]") {
    struct Line {
        double degrees, smallest, condition;
    };
    const auto line = GENERATE(
        Line{1e-6, 2.4e-8, 4.2e7}, Line{1e-3, 2.4e-5, 4.2e4}, Line{1.0, 0.024, 42.0}, Line{10.0, 0.24, 4.3},
        Line{45.0, 0.92, 1.19}, Line{90.0, 1.0, 1.44});
    for (const double theta :
         {radians(line.degrees), radians(180.0 - line.degrees), radians(540.0 + line.degrees)}) {
        CAPTURE(line.degrees, theta);
        const Verdict cosine = verdict_at(theta, ScrewAngleForm::cosine);
        CHECK(cosine.smallest == Approx(line.smallest).epsilon(0.025));  // two digits are tabled
        CHECK(cosine.condition == Approx(line.condition).epsilon(0.025));
        // the sine row is its mirror
        const Verdict sine = verdict_at(0.5 * kPi - theta, ScrewAngleForm::sine);
        CHECK(sine.smallest == Approx(line.smallest).epsilon(0.025));
    }
}

TEST_CASE("The cos row has rank 5 of 6 at kπ, the sine row at π/2 + kπ", "[core][screw]") {
    for (int k = -2; k <= 3; ++k) {
        CAPTURE(k);
        CHECK(verdict_at(k * kPi, ScrewAngleForm::cosine).rank == 5);
        CHECK(verdict_at(k * kPi, ScrewAngleForm::sine).rank == 6);
        CHECK(verdict_at((k + 0.5) * kPi, ScrewAngleForm::sine).rank == 5);
        CHECK(verdict_at((k + 0.5) * kPi, ScrewAngleForm::cosine).rank == 6);
    }
}

TEST_CASE("Driven over ten turns both ways, the nut advances by α (θ - θ0) throughout", "[core][screw]") {
    const double sense = GENERATE(1.0, -1.0);
    const double alpha = GENERATE(0.25, -0.01);
    Mechanism mechanism = test::screw(0.4, alpha, ScrewAngleForm::rotation);
    mechanism.drivers.push_back(
        {"theta", 0, 0, 1, ThetaMeasure{}, test::polynomial({0.4, sense * 2.0 * kPi})});
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    const Vec3 axis = Vec3(1.0, 2.0, 2.0) / 3.0;
    const auto nut = std::size_t{1};
    for (int k = 1; k <= 200; ++k) {
        const double t = 0.05 * k;
        REQUIRE(tracker.advance_to(t));
        const MotionFrame& frame = tracker.frame();
        const double theta = 0.4 + sense * 2.0 * kPi * t;
        CAPTURE(t);
        // 1e-12: a hundred roundings of 63 rad
        CHECK(std::abs(frame.state.theta[0] - theta) < 1e-12);
        CHECK(std::abs(axis.dot(frame.state.r[nut]) - alpha * theta) < 1e-12);
        CHECK(std::abs(axis.dot(frame.velocity.r_dot[nut]) - alpha * sense * 2.0 * kPi) < 1e-12);
        CHECK(frame.velocity_verdict.unique);
        CHECK(frame.velocity_verdict.consistent);
        CHECK(
            std::abs(std::remainder(relative_angle(mechanism.joints[0], frame.state) - theta, 2.0 * kPi)) <
            1e-12);
    }
    // ten turns were counted
    CHECK(std::abs(tracker.frame().state.theta[0] - 0.4) > 62.0);
}

TEST_CASE("An angle driver turns the nut over many turns as well, θ following", "[core][screw]") {
    Mechanism mechanism = test::screw(0.4, kAlpha, ScrewAngleForm::rotation);
    test::drive_angle(mechanism, 0, test::polynomial({0.4, 2.0}));
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start_state(mechanism), 0.0);
    for (int k = 1; k <= 100; ++k) { REQUIRE(tracker.advance_to(0.2 * k)); }
    CHECK(std::abs(tracker.frame().state.theta[0] - 40.4) < 1e-12);  // more than six turns
}

TEST_CASE("The cos row turns back beyond π, where the rotation row goes on", "[core][screw]") {
    const auto angle_after = [](ScrewAngleForm form, double theta) {
        // the nut stands at 3.1, θ is set to the given value: Newton's method turns the nut to it
        Mechanism mechanism = test::screw(3.1, kAlpha, form);
        mechanism.drivers.push_back({"theta", 0, 0, 1, ThetaMeasure{}, test::polynomial({theta})});
        const System system(mechanism, everything(mechanism));
        NewtonStepper<OmegaLocal> newton(system);
        State guess = start_state(mechanism);
        guess.theta[0] = theta;
        newton.start(guess, 0.0);
        REQUIRE(solve(newton).converged);
        const double angle = relative_angle(mechanism.joints[0], newton.state());
        return angle < 0.0 ? angle + 2.0 * kPi : angle;
    };
    for (const double theta : {3.2, 3.3}) {
        CAPTURE(theta);
        CHECK(angle_after(ScrewAngleForm::rotation, theta) == Approx(theta).epsilon(1e-12));
        // the mirror image; 1e-12 of an angle near the singular value sin 3.2 = 0.06
        CHECK(angle_after(ScrewAngleForm::cosine, theta) == Approx(2.0 * kPi - theta).epsilon(1e-11));
    }
}

TEST_CASE(
    "With the cos row at θ = π velocities are not unique and accelerations contradict", "[core][screw]") {
    const auto analyse = [](ScrewAngleForm form) {
        Mechanism mechanism = test::screw(kPi, kAlpha, form);
        mechanism.drivers.push_back({"theta", 0, 0, 1, ThetaMeasure{}, test::polynomial({kPi, 2.0})});
        const System system(mechanism, everything(mechanism));
        Kinematics<OmegaLocal> kinematics(system);
        kinematics.set_state(start_state(mechanism), 0.0);
        const VelocityOutcome velocity = kinematics.solve_velocity(zero_motion(mechanism));
        return std::pair(velocity, kinematics.solve_acceleration(velocity.velocity));
    };
    const auto [velocity, acceleration] = analyse(ScrewAngleForm::cosine);
    CHECK_FALSE(velocity.verdict.unique);
    CHECK(velocity.velocity.omega_local[1].norm() < 1e-12);  // minimum norm: the nut stands still
    CHECK_FALSE(acceleration.verdict.consistent);
    // γ of the cos row is θ̇² cos θ = 4 alone, which no acceleration can satisfy
    CHECK(acceleration.verdict.residual * 4.0 == Approx(4.0).epsilon(1e-12));

    const auto [good_velocity, good_acceleration] = analyse(ScrewAngleForm::rotation);
    CHECK(good_velocity.verdict.unique);
    CHECK(good_velocity.velocity.omega_local[1].norm() == Approx(2.0).epsilon(1e-13));
    CHECK(good_acceleration.verdict.consistent);
}
