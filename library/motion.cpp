#include "jointwise/trajectory.hpp"

#include <algorithm>
#include <array>

#include "core/integrate/simulation.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

/// Collects a motion moment by moment.
using Receive = std::function<void(const Moment&)>;

jw::Method method_named(const std::string& name) {
    const auto* found = std::ranges::find(jw::kMethods, name, &jw::MethodName::name);
    if (found != jw::kMethods.end()) { return found->method; }
    std::string names;
    for (const jw::MethodName& method : jw::kMethods) {
        names += (names.empty() ? "" : ", ") + std::string(method.name);
    }
    throw std::invalid_argument("jointwise: there is no method '" + name + "'; expected one of " + names);
}

/// Reasons why a simulation ended, in the order of SimulationFailure::Cause.
constexpr std::array kCauses{
    "redundant equations contradict the others",
    "no state satisfies the equations",
    "accelerations do not satisfy the equations of motion",
    "the step became too small",
    "a number is not finite",
    "a step turns a rotational spring too far for its turns to be counted",
    "there were too many steps"};
static_assert(kCauses.size() == static_cast<std::size_t>(jw::SimulationFailure::Cause::too_many_steps) + 1);

NotReached ended(const jw::SimulationFailure& failure) {
    const std::string of = failure.equation_of.empty() ? "" : " (" + failure.equation_of + ")";
    return NotReached(
        "jointwise: the motion ends at t = " + number_text(failure.t) +
        " s: " + kCauses[static_cast<std::size_t>(failure.cause)] + of);
}

jw::SimulationSettings settings_of(const Simulation& simulation) {
    jw::SimulationSettings settings;
    settings.method = method_named(simulation.method);
    settings.tolerance = simulation.tolerance;
    settings.step = simulation.step;
    return settings;
}

void follow_into(
    const Mechanism& mechanism, const std::vector<double>& times, const Receive& receive,
    const std::function<bool()>& go_on = {}) {
    expect_ascending(times);
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const jw::State start = state_of(inside, assemble(mechanism, times.front()));
    jw::System system(inside, jw::everything(inside));
    system.choose_rows(start);
    jw::MotionTracker tracker(system, start, times.front());
    for (const double t : times) {
        if (go_on && !go_on()) {
            throw NotReached("jointwise: the motion was given up before t = " + number_text(t) + " s");
        }
        if (!tracker.advance_to(t)) {
            throw NotReached(
                "jointwise: the motion ends at t = " + number_text(tracker.frame().t) +
                " s: " + row_name(system, tracker.failure()->row) + " cannot be satisfied beyond it");
        }
        const jw::MotionFrame& frame = tracker.frame();
        receive({pose_of(frame.state, t), rates_of(frame.velocity), rates_of(frame.acceleration), 0.0});
    }
}

void simulate_into(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings,
    const Receive& receive) {
    expect_ascending(times);
    if (times.front() < 0.0) {
        throw std::invalid_argument("jointwise: a time is below 0; motion starts at 0");
    }
    const auto& [inside, loads] = mechanism.inside();
    jw::Simulation simulation(inside, loads, settings_of(settings));
    const auto receive_state = [&](double t, const std::vector<double>& y) {
        const jw::Snapshot now = simulation.snapshot(t, y);
        const jw::Motion acceleration = simulation.acceleration_as_given(t, y);
        receive(
            {pose_of(now.state, t), rates_of(now.velocity), rates_of(acceleration),
             now.kinetic + now.potential});
    };
    jw::RunWatch watch;
    if (settings.go_on) {
        watch = [&](const jw::RunState&) { return settings.go_on(); };
    }
    const jw::SimulationOutcome outcome = simulation.run(times, receive_state, watch);
    if (outcome.failure) { throw ended(*outcome.failure); }
}

Trajectory empty_trajectory(const Mechanism& mechanism, std::size_t times) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const auto rows = static_cast<Eigen::Index>(times);
    const auto bodies = static_cast<Eigen::Index>(inside.bodies.size());
    const auto thetas = static_cast<Eigen::Index>(inside.thetas_count());
    Trajectory trajectory;
    trajectory.bodies = static_cast<int>(bodies);
    trajectory.t.resize(rows);
    trajectory.q.resize(rows, 7 * bodies + thetas);
    trajectory.q_dot.resize(rows, 6 * bodies + thetas);
    trajectory.q_ddot.resize(rows, 6 * bodies + thetas);
    trajectory.energy.resize(rows);
    return trajectory;
}

void write_rates(const Rates& rates, double* out) {
    for (std::size_t b = 0; b < rates.r_dot.size(); ++b, out += 6) {
        Eigen::Map<Vector3>{out} = rates.r_dot[b];
        Eigen::Map<Vector3>{out + 3} = rates.omega_local[b];
    }
    for (const double rate : rates.theta_dot) { *out++ = rate; }
}

void write_pose(const Pose& pose, double* out) {
    for (std::size_t b = 0; b < pose.r.size(); ++b, out += 7) {
        Eigen::Map<Vector3>{out} = pose.r[b];
        Eigen::Map<Vector4>{out + 3} = pose.p[b];
    }
    for (const double theta : pose.theta) { *out++ = theta; }
}

/// Writes each moment into the next row.
Receive writer_of(Trajectory& trajectory) {
    return [&trajectory, row = Eigen::Index{0}](const Moment& moment) mutable {
        trajectory.t(row) = moment.pose.t;
        trajectory.energy(row) = moment.energy;
        write_pose(moment.pose, trajectory.q.row(row).data());
        write_rates(moment.velocity, trajectory.q_dot.row(row).data());
        write_rates(moment.acceleration, trajectory.q_ddot.row(row).data());
        ++row;
    };
}

Rates rates_of_row(const Table& table, int row, int bodies) {
    Rates rates;
    const double* in = table.row(row).data();
    const double* const end = in + table.cols();
    for (int b = 0; b < bodies; ++b, in += 6) {
        rates.r_dot.emplace_back(in);
        rates.omega_local.emplace_back(in + 3);
    }
    rates.theta_dot.assign(in, end);
    return rates;
}

}  // namespace

std::vector<Moment> follow(const Mechanism& mechanism, const std::vector<double>& times) {
    std::vector<Moment> moments;
    follow_into(mechanism, times, [&](const Moment& moment) { moments.push_back(moment); });
    return moments;
}

std::vector<Moment> simulate(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings) {
    std::vector<Moment> moments;
    simulate_into(mechanism, times, settings, [&](const Moment& moment) { moments.push_back(moment); });
    return moments;
}

Moment Trajectory::moment(int row) const {
    if (row < 0 || row >= times()) {
        throw std::invalid_argument(
            "jointwise: there is no row " + std::to_string(row) + "; the trajectory has " +
            std::to_string(times()));
    }
    Moment moment;
    moment.pose.t = t(row);
    const double* in = q.row(row).data();
    const double* const end = in + q.cols();
    for (int b = 0; b < bodies; ++b, in += 7) {
        moment.pose.r.emplace_back(in);
        moment.pose.p.emplace_back(in + 3);
    }
    moment.pose.theta.assign(in, end);
    moment.velocity = rates_of_row(q_dot, row, bodies);
    moment.acceleration = rates_of_row(q_ddot, row, bodies);
    moment.energy = energy(row);
    return moment;
}

Trajectory follow_trajectory(
    const Mechanism& mechanism, const std::vector<double>& times, const std::function<bool()>& go_on) {
    Trajectory trajectory = empty_trajectory(mechanism, times.size());
    follow_into(mechanism, times, writer_of(trajectory), go_on);
    return trajectory;
}

Trajectory simulate_trajectory(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings) {
    Trajectory trajectory = empty_trajectory(mechanism, times.size());
    simulate_into(mechanism, times, settings, writer_of(trajectory));
    return trajectory;
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
