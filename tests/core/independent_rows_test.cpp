#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "core/equations/independent_rows.hpp"
#include "tests/support/scenes.hpp"

using namespace jw;
using test::radians;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

RowChoice choice_for(const Vec3& axis, ParallelForm form) {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_joint("p1", 0, body, Vec3::Zero(), axis).parallel_form = form;
    const System system(scene.mechanism, everything(scene.mechanism));
    return explain_choice(system, 0, start_state(scene.mechanism), -1);
}

/// Number of changes of the dropped index along a path of axes.
template <class Axis>
int switches_along(int steps, const Axis& axis) {
    int switches = 0;
    int dropped = choose_dropped(axis(0), -1);
    for (int k = 1; k <= steps; ++k) {
        const int next = choose_dropped(axis(k), dropped);
        if (next != dropped) { ++switches; }
        dropped = next;
    }
    return switches;
}

/// Largest condition 1/|s_drop| met along a path of unit axes.
template <class Axis>
double worst_condition_along(int steps, const Axis& axis) {
    double worst = 0.0;
    int dropped = -1;
    for (int k = 0; k <= steps; ++k) {
        dropped = choose_dropped(axis(k), dropped);
        worst = std::max(worst, 1.0 / std::abs(axis(k)(dropped)));
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "Each pair of rows has the condition number 1/|s_drop|, as tabled for an axis in the xz plane",
    "[core][independent_rows]") {
    struct Line {
        double degrees, drop_z, drop_x, rule;
    };
    const auto line = GENERATE(
        Line{15.0, 1.04, 3.86, 1.04}, Line{30.0, 1.15, 2.0, 1.15}, Line{60.0, 2.0, 1.15, 1.15},
        Line{75.0, 3.86, 1.04, 1.04}, Line{85.0, 11.5, 1.0, 1.0}, Line{89.0, 57.3, 1.0, 1.0},
        Line{89.9, 573.0, 1.0, 1.0}, Line{89.9999, 5.73e5, 1.0, 1.0});
    const double a = radians(line.degrees);
    const Vec3 axis(std::sin(a), 0.0, std::cos(a));
    CAPTURE(line.degrees);
    const RowChoice choice = choice_for(axis, ParallelForm::rule);
    CHECK((choice.s_i - axis).norm() < 1e-15 * 10.0);  // turned into the body and back
    // three digits are tabled
    CHECK(choice.pair_condition[2] == Approx(line.drop_z).epsilon(5e-3));
    CHECK(choice.pair_condition[0] == Approx(line.drop_x).epsilon(5e-3));
    CHECK(choice.form_condition == Approx(line.rule).epsilon(5e-3));
    // closed form; 1e-16 of the largest singular value is 1e-16 times the condition of the smallest
    CHECK(choice.pair_condition[2] == Approx(1.0 / std::cos(a)).epsilon(1e-14 / std::cos(a)));
    CHECK(choice.pair_condition[0] == Approx(1.0 / std::sin(a)).epsilon(1e-13));
    // nothing is left of y but the rounding of the axis
    CHECK(choice.pair_condition[1] > 1e14);
    CHECK(choice.dropped == (line.degrees < 45.0 ? 2 : 0));
    // three rows at once have the two singular values 1 and 1
    CHECK(choice_for(axis, ParallelForm::all_three).form_condition == Approx(1.0).epsilon(1e-13));
    CHECK(choice_for(axis, ParallelForm::pair).form_condition == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("A forced drop keeps its bad pair, the rule never does", "[core][independent_rows]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    // frames in line with the axes, so that the zeros are exact
    for (Body& b : scene.mechanism.bodies) { b.p = Vec4::Unit(0); }
    scene.add_joint("p1", 0, body, Vec3::Zero(), Vec3::UnitX());
    const auto choice = [&](ParallelForm form) {
        scene.mechanism.joints[0].parallel_form = form;
        const System system(scene.mechanism, everything(scene.mechanism));
        return explain_choice(system, 0, start_state(scene.mechanism), -1);
    };
    CHECK(choice(ParallelForm::drop_x).form_condition == Approx(1.0).epsilon(1e-14));
    CHECK(choice(ParallelForm::drop_y).form_condition == kInfinite);
    CHECK(choice(ParallelForm::drop_z).form_condition == kInfinite);
    CHECK(choice(ParallelForm::rule).dropped == 0);
    CHECK(choice(ParallelForm::rule).form_condition == Approx(1.0).epsilon(1e-14));
    for (const ParallelForm form : {ParallelForm::drop_z, ParallelForm::rule, ParallelForm::pair}) {
        CHECK(choice(form).pair_condition[1] == kInfinite);
        CHECK(choice(form).pair_condition[2] == kInfinite);
    }
}

TEST_CASE(
    "A revolute whose z equation is dropped has rank 4 about x and 5 under the rule",
    "[core][independent_rows]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    Joint& joint = scene.add_joint("revolute", 0, body, Vec3(0.3, 0.2, 0.1), Vec3::UnitX());
    joint.parallel_form = ParallelForm::drop_z;
    CHECK(test::rank_of(scene.mechanism).rank == 4);
    joint.parallel_form = ParallelForm::rule;
    CHECK(test::rank_of(scene.mechanism).rank == 5);
    joint.parallel_form = ParallelForm::all_three;
    CHECK(test::rank_of(scene.mechanism).rank == 5);
    CHECK(test::rank_of(scene.mechanism).rows == 6);
    joint.parallel_form = ParallelForm::pair;
    CHECK(test::rank_of(scene.mechanism).rank == 5);
}

TEST_CASE("The worst axis for the rule is (1,1,1), with condition √3", "[core][independent_rows]") {
    CHECK(
        choice_for(Vec3(1.0, 1.0, 1.0), ParallelForm::rule).form_condition ==
        Approx(std::sqrt(3.0)).epsilon(1e-13));
    for (unsigned seed = 1; seed <= 200; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        // without a past the largest component is at least 1/√3; 1e-12 for rounding
        CHECK(choice_for(random.direction(), ParallelForm::rule).form_condition < std::sqrt(3.0) + 1e-12);
    }
}

TEST_CASE("Noise of 0.02 on the axis (1,1,1) switches nothing in 20000 steps", "[core][independent_rows]") {
    test::Random random(5);
    std::vector<Vec3> axes;
    for (int k = 0; k <= 20000; ++k) { axes.push_back(Vec3::Ones().normalized() + random.vector(0.02)); }
    CHECK(switches_along(20000, [&](int k) { return axes[static_cast<std::size_t>(k)]; }) == 0);
    // the test is not trivial: the largest component itself changes thousands of times
    int changes = 0;
    for (std::size_t k = 1; k < axes.size(); ++k) {
        changes += choose_dropped(axes[k], -1) != choose_dropped(axes[k - 1], -1) ? 1 : 0;
    }
    CHECK(changes > 10000);
}

TEST_CASE(
    "A turn of the axis switches as often as it must, and the condition stays below √3/0.8",
    "[core][independent_rows]") {
    const int steps = 3600;
    const auto angle = [&](int k) { return 2.0 * test::kPi * k / steps; };
    const auto in_xz = [&](int k) { return Vec3(std::sin(angle(k)), 0.0, std::cos(angle(k))); };
    CHECK(switches_along(steps, in_xz) == 4);
    // of the largest 1: |s_drop| >= 0.8 max and max >= 1/√2 in a plane
    CHECK(worst_condition_along(steps, in_xz) < std::sqrt(2.0) / kKeepRatio);
    CHECK(worst_condition_along(steps, in_xz) == Approx(1.60).epsilon(5e-3));

    const Vec3 a = Vec3(1.0, -1.0, 0.0).normalized();
    const Vec3 b = Vec3(1.0, 1.0, -2.0).normalized();
    const auto oblique = [&](int k) { return Vec3(std::cos(angle(k)) * a + std::sin(angle(k)) * b); };
    CHECK(switches_along(steps, oblique) == 5);
    CHECK(worst_condition_along(steps, oblique) == Approx(1.62).epsilon(5e-3));

    test::Random random(9);
    Vec3 axis = random.direction();
    const auto wander = [&](int) {
        axis = (axis + random.vector(0.1)).normalized();
        return axis;
    };
    double worst = 0.0;
    int dropped = -1;
    for (int k = 0; k < 20000; ++k) {
        const Vec3 s = wander(k);
        dropped = choose_dropped(s, dropped);
        worst = std::max(worst, 1.0 / std::abs(s(dropped)));
    }
    CHECK(worst < std::sqrt(3.0) / kKeepRatio);
    CHECK(worst > std::sqrt(3.0));  // the walk did come near the bound
}

TEST_CASE("The choice is by direction only and signs do not matter", "[core][independent_rows]") {
    CHECK(choose_dropped(Vec3(0.1, -5.0, 2.0), -1) == 1);
    CHECK(choose_dropped(1e-8 * Vec3(0.1, -5.0, 2.0), -1) == 1);
    // just above the ratio the choice stays, just below it changes
    CHECK(choose_dropped(Vec3(1.0, 0.80001, 0.0), 1) == 1);
    CHECK(choose_dropped(Vec3(1.0, 0.79999, 0.0), 1) == 0);
}
