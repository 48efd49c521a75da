#include "core/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jw {

int Mechanism::moving_bodies_count() const {
    return static_cast<int>(std::ranges::count_if(bodies, [](const Body& b) { return !b.fixed; }));
}

std::vector<int> Mechanism::theta_indices() const {
    std::vector<int> indices;
    int next = 0;
    for (const Joint& joint : joints) { indices.push_back(joint.type->artificial > 0 ? next++ : -1); }
    return indices;
}

int Mechanism::thetas_count() const {
    return static_cast<int>(
        std::ranges::count_if(joints, [](const Joint& j) { return j.type->artificial > 0; }));
}

State start_state(const Mechanism& mechanism) {
    State state;
    for (const Body& body : mechanism.bodies) {
        state.r.push_back(body.r);
        state.p.push_back(body.p);
    }
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        state.theta.push_back(joint.geometry.theta_start.value_or(relative_angle(joint, state)));
    }
    return state;
}

Motion zero_motion(const Mechanism& mechanism) {
    Motion motion;
    motion.r_dot.assign(mechanism.bodies.size(), Vec3::Zero());
    motion.omega_local.assign(mechanism.bodies.size(), Vec3::Zero());
    motion.theta_dot.assign(static_cast<std::size_t>(mechanism.thetas_count()), 0.0);
    return motion;
}

Motion start_motion(const Mechanism& mechanism) {
    Motion motion = zero_motion(mechanism);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (mechanism.bodies[b].fixed) { continue; }
        motion.r_dot[b] = mechanism.bodies[b].r_dot;
        motion.omega_local[b] = mechanism.bodies[b].omega_local;
    }
    std::size_t theta = 0;
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        const auto omega_of = [&](int body) -> Vec3 {
            const auto b = static_cast<std::size_t>(body);
            return homogeneous_rotation_matrix(mechanism.bodies[b].p) * motion.omega_local[b];
        };
        const Vec3 s_i =
            homogeneous_rotation_matrix(mechanism.bodies[static_cast<std::size_t>(joint.body_i)].p) *
            joint.geometry.s_i_local.normalized();
        motion.theta_dot[theta++] =
            joint.geometry.theta_dot_start.value_or(s_i.dot(omega_of(joint.body_j) - omega_of(joint.body_i)));
    }
    return motion;
}

AngleMeasure angle_of(const Joint& joint) {
    return {joint.geometry.s_i_local.normalized(), joint.geometry.u_i_local, joint.geometry.u_j_local};
}

DisplacementMeasure displacement_of(const Joint& joint) {
    return {joint.geometry.s_i_local.normalized(), joint.geometry.P_i_local, joint.geometry.P_j_local};
}

double relative_angle(const Joint& joint, const State& state) {
    const auto i = static_cast<std::size_t>(joint.body_i);
    const auto j = static_cast<std::size_t>(joint.body_j);
    const Mat3 A_i = homogeneous_rotation_matrix(state.p[i]);
    const Vec3 u_i = A_i * joint.geometry.u_i_local;
    const Vec3 u_j = homogeneous_rotation_matrix(state.p[j]) * joint.geometry.u_j_local;
    return std::atan2(u_i.cross(u_j).dot(A_i * joint.geometry.s_i_local.normalized()), u_i.dot(u_j));
}

double screw_angle(const Joint& joint, const State& state) {
    const double angle = relative_angle(joint, state);
    const JointGeometry& g = joint.geometry;
    if (g.alpha == 0.0) { return angle; }
    const auto point = [&](int body, const Vec3& s_local) -> Vec3 {
        const auto b = static_cast<std::size_t>(body);
        return state.r[b] + homogeneous_rotation_matrix(state.p[b]) * s_local;
    };
    const Mat3 A_i = homogeneous_rotation_matrix(state.p[static_cast<std::size_t>(joint.body_i)]);
    const Vec3 d = point(joint.body_j, g.P_j_local) - point(joint.body_i, g.P_i_local);
    const double by_advance = g.theta_0 + ((A_i * g.s_i_local.normalized()).dot(d) - g.d_0) / g.alpha;
    constexpr double turn = 2.0 * std::numbers::pi;
    return angle + turn * std::round((by_advance - angle) / turn);
}

double angle_rate(const Joint& joint, const State& state, const Motion& motion) {
    const auto i = static_cast<std::size_t>(joint.body_i);
    const auto j = static_cast<std::size_t>(joint.body_j);
    const Mat3 A_i = homogeneous_rotation_matrix(state.p[i]);
    const Vec3 omega_i = A_i * motion.omega_local[i];
    const Vec3 omega_j = homogeneous_rotation_matrix(state.p[j]) * motion.omega_local[j];
    return (A_i * joint.geometry.s_i_local.normalized()).dot(omega_j - omega_i);
}

double extent(const Mechanism& mechanism) {
    double largest = 0.0;
    for (const Joint& joint : mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        largest = std::max({largest, g.P_i_local.norm(), g.P_j_local.norm(), g.length});
    }
    for (const Body& body : mechanism.bodies) {
        largest = std::max(largest, (body.r - mechanism.bodies.front().r).norm());
    }
    return largest > 0.0 ? largest : 1.0;
}

double unit_of_length(const Mechanism& mechanism) {
    return std::pow(1000.0, std::round(std::log10(extent(mechanism)) / 3.0));
}

}  // namespace jw
