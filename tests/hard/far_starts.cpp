#include <array>
#include <cmath>
#include <numbers>

#include "core/poses/newton_methods.hpp"
#include "core/poses/position.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/shipped.hpp"
#include "tests/hard/variants.hpp"

/// Newton from starts that lie nearer to a solution that is not meant than to the one that is.
namespace jw::hard {

namespace {

/// A lesson's first joint alone, its second body turned by `angle` from an orientation that satisfies it.
State turned_away(const Mechanism& mechanism, const State& good, const Vec3& axis, double angle) {
    State state = good;
    const auto j = static_cast<std::size_t>(mechanism.joints[0].body_j);
    state.p[j] = turned_global(state.p[j], angle * axis.normalized());
    return state;
}

double axes_cosine(const Joint& joint, const State& state) {
    const Vec3 s_i = rotation_matrix(state.p[static_cast<std::size_t>(joint.body_i)]) *
                     joint.geometry.s_i_local.normalized();
    const Vec3 s_j = rotation_matrix(state.p[static_cast<std::size_t>(joint.body_j)]) *
                     joint.geometry.s_j_local.normalized();
    return s_i.dot(s_j);
}

/// Result of Newton's method of slide 23 with full steps, which is not checked afterwards.
struct Ended {
    bool closed = false;
    State state;
};
Ended plain_newton(const System& system, const State& start) {
    const NewtonTrace trace = trace_newton<OmegaLocal>(system, start, 0.0, NewtonMethod::plain);
    return {trace.converged, trace.converged ? trace.iterates.back().state : start};
}

bool upside_down(const Joint& joint, const Ended& ended) {
    return ended.closed && axes_cosine(joint, ended.state) < 0.0;
}

struct Count {
    int starts = 0;
    int naive_closed = 0;
    int naive_wrong = 0;
    int ours_right = 0;
};

/// Turns the second body of the lesson's first joint by `angle` about random axes across the joint's.
void count_from(const char* name, double angle, int starts, Count& count) {
    const Mechanism mechanism = assembled_mechanism(name);
    const System system(mechanism, Selection{{0}, {}});
    const Joint& joint = mechanism.joints[0];
    const Vec3 s_i = rotation_matrix(mechanism.bodies[0].p) * joint.geometry.s_i_local;
    const State good = start_state(mechanism);
    Dice dice(6);
    for (int k = 0; k < starts; ++k) {
        State state = turned_away(mechanism, good, s_i.cross(dice.direction()), angle);
        ++count.starts;
        const Ended naive = plain_newton(system, state);
        count.naive_closed += naive.closed ? 1 : 0;
        count.naive_wrong += upside_down(joint, naive) ? 1 : 0;
        const bool ok = solve_position<OmegaLocal>(system, state, 0.0).ok();
        count.ours_right +=
            ok && axes_cosine(joint, state) > 0.0 && is_meant(system, state, intended_sides(system)) ? 1 : 0;
    }
}

}  // namespace

Result anti_parallel_start() {
    const Mechanism mechanism = assembled_mechanism("hard/anti-parallel.toml");
    const System system(mechanism, Selection{{0}, {}});
    const Joint& joint = mechanism.joints[0];
    State state = turned_away(mechanism, start_state(mechanism), Vec3::UnitX(), std::numbers::pi);
    const Ended naive = plain_newton(system, state);
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    State middle = turned_away(mechanism, start_state(mechanism), Vec3::UnitX(), 90.0 * kDegree);
    const PositionOutcome at_90 = solve_position<OmegaLocal>(system, middle, 0.0);
    Count sweep;
    for (int angle = 5; angle <= 175; angle += 10) {
        count_from("hard/anti-parallel.toml", angle * kDegree, 1, sweep);
    }
    Result result;
    result.naive =
        "s_i x s_j = 0 holds to the last digit for the upside-down top, so the method converges without a "
        "single step.";
    result.ours =
        "s_i · s_j > 0, which no equation contains, is checked after every solution. If it does not hold, "
        "the body is turned by half a turn and the equations are solved again.";
    // 180 deg: cosines of rounded vectors
    result.measurements.push_back(of_both(
        "s_i · s_j found, from exactly 180 deg off", axes_cosine(joint, naive.state), at_most(-0.99),
        outcome.ok() ? axes_cosine(joint, state) : -1.0, at_least(0.999999)));
    result.measurements.push_back(of_both(
        "not as intended, of 18 starts 5 to 175 deg off",
        double(sweep.naive_wrong + sweep.starts - sweep.naive_closed), at_least(8.0),
        double(sweep.starts - sweep.ours_right), exactly(0.0)));
    // half way between the two solutions the equations lose rank, and neither solution is nearer
    result.measurements.push_back(of_ours(
        "exactly 90 deg off: reported as singular (1)",
        !at_90.ok() && at_90.failure->cause == FailureCause::singular ? 1.0 : 0.0, exactly(1.0)));
    return result;
}

Result start_170_degrees_off() {
    constexpr std::array kLessons{
        "joints/revolute.toml", "joints/cylindrical.toml", "joints/prismatic.toml", "joints/screw.toml"};
    Count count;
    for (const char* lesson : kLessons) { count_from(lesson, 170.0 * kDegree, 50, count); }
    Result result;
    result.naive = "the nearest solution is upside down; full steps lead to it or do not converge.";
    result.ours =
        "steps of at most 0.5 rad lead to the nearest solution; it is recognised as wrong and left.";
    result.measurements.push_back(of_both(
        "joints assembled as intended, of 200", double(count.naive_closed - count.naive_wrong), at_most(20.0),
        double(count.ours_right), exactly(200.0)));
    result.measurements.push_back(
        of_naive("assembled upside down without a message", double(count.naive_wrong), at_least(100.0)));
    return result;
}

}  // namespace jw::hard
