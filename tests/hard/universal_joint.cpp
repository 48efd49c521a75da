#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/kinematics/kinematics.hpp"
#include "core/poses/newton_methods.hpp"
#include "core/poses/position.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

namespace {

/// The lesson's bob, its arm turned from perpendicular to `angle` [rad] against the other; the point stays.
Mechanism arms_at(Mechanism mechanism, double angle) {
    const JointGeometry& g = mechanism.joints[0].geometry;
    Body& bob = mechanism.bodies[1];
    const Vec3 s_i = rotation_matrix(mechanism.bodies[0].p) * g.s_i_local;
    const Vec3 s_j = rotation_matrix(bob.p) * g.s_j_local;
    const Vec3 point = bob.r + rotation_matrix(bob.p) * g.P_j_local;
    bob.p = turned_global(bob.p, (angle - 0.5 * std::numbers::pi) * s_i.cross(s_j).normalized());
    bob.r = point - rotation_matrix(bob.p) * g.P_j_local;
    return mechanism;
}

/// The lesson's shafts with another bend [rad] and the first one turned by φ, assembled by hand.
Mechanism shafts(Mechanism mechanism, double bend, double phi) {
    // exact at 0 and 90 deg
    const double cosine = bend == 0.5 * std::numbers::pi ? 0.0 : std::cos(bend);
    const Vec3 out(cosine, 0.0, std::sin(bend));
    const Vec3 arm_in(0.0, -std::sin(phi), std::cos(phi));
    const Vec3 across = arm_in.cross(out);
    // where the first arm lies along the second shaft, the second may lie along the first
    const Vec3 arm_out = across.norm() > 1e-8 ? across.normalized() : Vec3(Vec3::UnitX());
    Mat3 A;
    A << out, arm_out, out.cross(arm_out);

    JointGeometry& bearing = mechanism.joints[2].geometry;
    const Vec3 centre = mechanism.bodies[1].r;
    bearing.P_i_local = centre + bearing.P_j_local.x() * out;
    bearing.s_i_local = out;
    mechanism.bodies[1].p = euler_parameters_of(Vec3::UnitX(), phi);
    mechanism.bodies[2].r = centre;
    mechanism.bodies[2].p = euler_parameters_of(A);
    return mechanism;
}

/// A driver that turns a joint by 1 rad/s.
Mechanism driven(Mechanism mechanism, std::size_t joint) {
    const Joint& j = mechanism.joints[joint];
    TimeFunction even;
    even.polynomial = {relative_angle(j, start_state(mechanism)), 1.0};
    mechanism.drivers.push_back({"drive", int(joint), j.body_i, j.body_j, angle_of(j), even});
    return mechanism;
}

struct Velocities {
    double naive_ratio = 0.0;
    double ratio = 0.0;
    double naive_miss = 0.0;  ///< largest |Φq q̇ - ν|
    LinearVerdict verdict;
};

/// Speed of the second shaft by both methods.
Velocities velocities_of(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Kinematics<OmegaLocal> kinematics(system);
    kinematics.set_state(start_state(mechanism), 0.0);
    const VelocityOutcome outcome = kinematics.solve_velocity(zero_motion(mechanism));
    const Assembler<OmegaLocal>& assembler = kinematics.assembler();
    const VectorX naive = by_normal_equations(assembler.jacobian(), assembler.nu());
    Velocities velocities;
    velocities.naive_ratio = naive(9);  // x of ω' of the second shaft, along it
    velocities.ratio = outcome.velocity.omega_local[2].x();
    const double miss = (assembler.jacobian() * naive - assembler.nu()).cwiseAbs().maxCoeff();
    velocities.naive_miss = std::isfinite(miss) ? miss : 1e300;
    velocities.verdict = outcome.verdict;
    return velocities;
}

/// Largest turn of any body in one Newton step [deg].
double largest_step(const System& system, const State& start, NewtonMethod method) {
    double turn = 0.0;
    for (const NewtonIterate& iterate : trace_newton<OmegaLocal>(system, start, 0.0, method).iterates) {
        turn = std::max(turn, iterate.fraction * iterate.turn);
    }
    return turn / kDegree;
}

double said_singular(const PositionOutcome& outcome) {
    return !outcome.ok() && outcome.failure->cause == FailureCause::singular ? 1.0 : 0.0;
}

}  // namespace

Result parallel_arms() {
    const Mechanism mechanism = assembled_mechanism("joints/universal.toml");
    const System system(mechanism, everything(mechanism));
    double naive_step = 0.0;
    double step = 0.0;
    double turn = 0.0;
    int closed = 0;
    constexpr std::array kDegrees{10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6};
    for (const double degrees : kDegrees) {
        State state = start_state(arms_at(mechanism, degrees * kDegree));
        naive_step = std::max(naive_step, largest_step(system, state, NewtonMethod::plain));
        step = std::max(step, largest_step(system, state, NewtonMethod::stepwise_limited));
        const State start = state;
        closed += solve_position<OmegaLocal>(system, state, 0.0).ok() ? 1 : 0;
        turn = std::max(turn, turn_local_between(start.p[1], state.p[1]).norm() / kDegree);
    }
    const Mechanism exact = arms_at(mechanism, 0.0);
    State state = start_state(exact);
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    const NewtonTrace naive = trace_newton<OmegaLocal>(system, state, 0.0, NewtonMethod::plain);
    Result result;
    result.naive =
        "the residual is divided by a derivative that is nearly zero. The body turns by a huge angle, and "
        "where it ends is chance. If the arms are exactly parallel, it stays where it is.";
    result.ours =
        "no step turns a body by more than 0.5 rad, so the nearest solution is found. If the arms are "
        "exactly parallel, no direction is better than another; the program says so and leaves the body "
        "where it was.";
    result.measurements.push_back(
        of_ours("rank of the 4 rows with parallel arms", double(verdict_on(exact).rank), exactly(3.0)));
    result.measurements.push_back(
        of_ours("closed from 10, 1, ... 1e-6 deg, of 8", double(closed), exactly(8.0)));
    // 0.5 rad
    result.measurements.push_back(
        of_both("largest turn in one step [deg]", naive_step, at_least(1e8), step, at_most(28.7)));
    // the nearest solution is 90 deg away; besides, the point stays fixed
    result.measurements.push_back(of_ours("largest turn from start to solution [deg]", turn, at_most(91.0)));
    result.measurements.push_back(
        of_naive("exactly parallel: closed (1)", naive.converged ? 1.0 : 0.0, exactly(0.0)));
    result.measurements.push_back(
        of_ours("exactly parallel: reported as singular (1)", said_singular(outcome), exactly(1.0)));
    return result;
}

Result bend_of_90_degrees() {
    const Mechanism lesson = assembled_mechanism("loops/cardan.toml");
    const double right_angle = 0.5 * std::numbers::pi;
    const auto rank_at = [&](double bend, double phi) {
        return double(verdict_on(shafts(lesson, bend, phi)).rank);
    };
    const double near = 90.0 - 1e-5;
    const Velocities fast = velocities_of(driven(shafts(lesson, near * kDegree, 0.0), 0));
    const double ratio = 1.0 / std::cos(near * kDegree);
    const Velocities locked = velocities_of(driven(shafts(lesson, right_angle, 0.3), 2));
    Result result;
    result.naive =
        "if the locked shaft is driven, it returns velocities that violate the joints, without a message.";
    result.ours =
        "shafts in line are a pose like any other; where two branches cross, the rank shows it. If the "
        "locked shaft is driven, the program reports that the equations contradict each other.";
    result.measurements.push_back(
        of_ours("rank of 14 rows, shafts in line", rank_at(0.0, 0.3), exactly(11.0)));
    result.measurements.push_back(of_ours("rank at 40 deg", rank_at(40.0 * kDegree, 0.3), exactly(11.0)));
    result.measurements.push_back(of_ours("rank at 90 deg", rank_at(right_angle, 0.3), exactly(11.0)));
    result.measurements.push_back(
        of_ours("rank at 90 deg, arms along each other's shafts", rank_at(right_angle, 0.0), exactly(10.0)));
    // the ratio is 5.7e6, so is the condition: 1e-16 of the pose times that, with room for a few roundings
    result.measurements.push_back(of_both(
        "relative error of the ratio at 89.99999 deg", std::abs(fast.naive_ratio / ratio - 1.0), any(),
        std::abs(fast.ratio / ratio - 1.0), at_most(1e-8)));
    // 1 rad/s is prescribed; a contradiction misses it by a fraction of that, rounding by some 1e-16
    result.measurements.push_back(of_both(
        "locked shaft driven: largest miss of an equation", locked.naive_miss, at_least(0.05),
        locked.verdict.residual, at_least(0.05)));
    result.measurements.push_back(of_ours(
        "locked shaft driven: contradiction reported (1)", locked.verdict.consistent ? 0.0 : 1.0,
        exactly(1.0)));
    return result;
}

}  // namespace jw::hard
