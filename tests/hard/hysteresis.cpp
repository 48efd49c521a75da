#include <algorithm>
#include <cmath>

#include "tests/hard/cases.hpp"
#include "tests/hard/shipped.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

namespace {

/// The rule without a memory: drop the largest component.
int largest_component(const Vec3& s_i) {
    Eigen::Index largest = 0;
    s_i.cwiseAbs().maxCoeff(&largest);
    return static_cast<int>(largest);
}

/// Condition of the two rows that are left, 1/|s_drop| of a unit axis.
double condition(const Vec3& s_i, int dropped) { return s_i.norm() / std::abs(s_i(dropped)); }

struct Switches {
    int naive = 0;
    int ours = 0;
    double naive_condition = 0.0;
    double condition = 0.0;
};

/// The axis of the lesson's turntable, its direction wrong by up to `noise` in every sample.
Switches under_noise(double noise, int samples) {
    const Lesson lesson = shipped_lesson("parallel/which-two-of-three.toml");
    const Mechanism& mechanism = lesson.mechanism;
    System system(mechanism, Selection{{0}, {}});
    const Vec3 s_i_local = mechanism.joints[0].geometry.s_i_local;
    State state = start_state(mechanism);
    const auto body = static_cast<std::size_t>(mechanism.joints[0].body_i);
    const Vec4 p = state.p[body];
    Dice dice(4);
    Switches switches;
    int naive = largest_component(rotation_matrix(p) * s_i_local);
    for (int k = 0; k < samples; ++k) {
        state.p[body] = turned_local(p, dice.vector(noise));
        const int now = largest_component(rotation_matrix(state.p[body]) * s_i_local);
        switches.naive += now != naive ? 1 : 0;
        naive = now;
        switches.ours += system.choose_rows(state) ? 1 : 0;
    }
    return switches;
}

/// The axis wanders over the whole sphere in small steps.
Switches on_the_way_round(int samples) {
    Dice dice(5);
    Switches switches;
    Vec3 s_i = Vec3::UnitZ();
    int naive = 2;
    int ours = 2;
    for (int k = 0; k < samples; ++k) {
        s_i = (s_i + dice.vector(0.1)).normalized();
        const int naive_now = largest_component(s_i);
        const int ours_now = choose_dropped(s_i, ours);
        switches.naive += naive_now != naive ? 1 : 0;
        switches.ours += ours_now != ours ? 1 : 0;
        naive = naive_now;
        ours = ours_now;
        switches.naive_condition = std::max(switches.naive_condition, condition(s_i, naive));
        switches.condition = std::max(switches.condition, condition(s_i, ours));
    }
    return switches;
}

}  // namespace

Result axis_at_the_diagonal() {
    const Switches noise = under_noise(1e-12, 20000);
    const Switches round = on_the_way_round(20000);
    Result result;
    result.naive =
        "the three components have the same size, so in every pose rounding decides again which is the "
        "largest. Every switch changes the equations, the multipliers and the layout.";
    result.ours =
        "the choice is kept until the component that is left out is below 0.8 of the largest. The condition "
        "number can then reach √3 / 0.8 instead of √3.";
    // two in three of 20000 random samples choose another component than the sample before
    result.measurements.push_back(of_both(
        "switches in 20000 poses at (1, 1, 1) ± 1e-12", double(noise.naive), at_least(10000.0),
        double(noise.ours), exactly(0.0)));
    result.measurements.push_back(of_both(
        "switches of an axis wandering over the sphere", double(round.naive), any(), double(round.ours),
        at_most(round.naive)));
    // closed forms: the largest component is at least 1/√3, the kept one at least 0.8 of that
    result.measurements.push_back(of_both(
        "worst condition of the kept pair there", round.naive_condition, at_most(1.7321), round.condition,
        at_most(2.17)));
    return result;
}

}  // namespace jw::hard
