#include "jointwise/trajectory.hpp"

#include "library/inside.hpp"
#include "library/motion.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

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
