#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/shipped.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurnsOfScrew = 1000.0;
constexpr double kTurnsPerSecond = 0.5;  // of the lesson's driver

Lesson screw_lesson(ScrewAngleForm form) {
    Lesson lesson = shipped_lesson("joints/screw.toml");
    lesson.mechanism.joints[0].geometry.screw_angle_form = form;
    return lesson;
}

/// The lesson's nut turned to θ by hand, exactly on its thread.
Mechanism nut_at(double theta, ScrewAngleForm form) {
    Mechanism mechanism = screw_lesson(form).mechanism;
    mechanism.drivers.clear();
    JointGeometry& g = mechanism.joints[0].geometry;
    Body& nut = mechanism.bodies[1];
    nut.p = euler_parameters_of(g.s_i_local, theta);
    nut.r = g.P_i_local + (g.d_0 + g.alpha * (theta - g.theta_0)) * g.s_i_local.normalized();
    g.theta_start = theta;
    return mechanism;
}

struct Row {
    int rank = 1000;
    double condition = 0.0;

    void look_at(const Mechanism& mechanism) {
        const RankReport report = verdict_on(mechanism);
        const VectorX& sigma = report.singular_values;
        rank = std::min(rank, report.rank);
        condition = std::max(condition, sigma(0) / std::max(sigma(5), 1e-16 * sigma(0)));
    }
};

/// Largest error of the nut's angle in two turns that Newton's method drives from pose to pose [deg].
double error_after_two_turns(ScrewAngleForm form) {
    Lesson lesson = screw_lesson(ScrewAngleForm::rotation);
    const State start = assembled(lesson);
    lesson.mechanism.joints[0].geometry.screw_angle_form = form;
    const System system(lesson.mechanism, everything(lesson.mechanism));
    NewtonStepper<OmegaLocal> newton(system);
    State state = start;
    double worst = 0.0;
    for (int k = 1; k <= 80; ++k) {
        const double t = 0.05 * k;
        newton.start(state, t);
        solve(newton);
        state = newton.state();
        const double asked = 2.0 * kPi * kTurnsPerSecond * t;
        const double angle = relative_angle(lesson.mechanism.joints[0], state);
        worst = std::max(worst, std::abs(std::remainder(angle - asked, 2.0 * kPi)));
    }
    return worst / kDegree;
}

}  // namespace

Result cosine_row_at_half_turns() {
    Row naive;
    Row ours;
    for (int k = -4; k <= 4; ++k) {
        naive.look_at(nut_at(k * kPi, ScrewAngleForm::cosine));
        ours.look_at(nut_at(k * kPi, ScrewAngleForm::rotation));
    }
    Result result;
    result.naive =
        "the derivative of cos θ is zero at 0, 180 and 360 deg, so the row is empty there. Beyond these "
        "angles the nut turns back while θ and the advance go on, because the cosine is even.";
    result.ours = "this is sin(angle - θ) = 0, and the row is the same at every angle.";
    result.measurements.push_back(of_both(
        "least rank of the 6 rows at θ = k 180 deg", double(naive.rank), exactly(5.0), double(ours.rank),
        exactly(6.0)));
    // closed form √(2 + α²), α = 0.12 m / 2π
    result.measurements.push_back(of_both(
        "worst condition number there", naive.condition, at_least(1e9), ours.condition, at_most(1.415)));
    // Newton's tolerance is 1e-13 rad; the bound is in degrees, with a factor of ten for accumulated errors
    result.measurements.push_back(of_both(
        "error of the nut's angle in two turns [deg]", error_after_two_turns(ScrewAngleForm::cosine),
        at_least(90.0), error_after_two_turns(ScrewAngleForm::rotation), at_most(1e-10)));
    return result;
}

Result a_thousand_turns() {
    const Lesson lesson = screw_lesson(ScrewAngleForm::rotation);
    const Joint& thread = lesson.mechanism.joints[0];
    const JointGeometry& g = thread.geometry;
    System system(lesson.mechanism, everything(lesson.mechanism));
    MotionTracker tracker(system, assembled(lesson), 0.0);
    const auto advance = [&](double theta) { return g.d_0 + g.alpha * (theta - g.theta_0); };
    double naive = 0.0;
    double ours = 0.0;
    int lost = 0;
    for (int k = 1; k <= 4 * int(kTurnsOfScrew); ++k) {
        const double t = 0.25 * k / kTurnsPerSecond;
        if (!tracker.advance_to(t)) {
            ++lost;
            break;
        }
        const State& state = tracker.frame().state;
        const double asked = advance(2.0 * kPi * kTurnsPerSecond * t);
        const double moved = g.s_i_local.normalized().dot(state.r[1] - g.P_i_local);
        naive = std::max(naive, std::abs(advance(relative_angle(thread, state)) - asked));
        ours = std::max(ours, std::abs(moved - asked));
    }
    Result result;
    result.naive = "after every turn the angle is back where it was, and so is the advance.";
    result.ours = "θ is predicted along with the motion and counts the turns.";
    result.measurements.push_back(of_ours("poses lost, of 4000", double(lost), exactly(0.0)));
    // 120 m are known to 1.4e-14 m, and Newton stops at 1e-13 of the largest coordinate
    result.measurements.push_back(
        of_both("error of the advance in 1000 turns [m]", naive, at_least(119.0), ours, at_most(1.2e-11)));
    return result;
}

}  // namespace jw::hard
