#include "core/model/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"

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
        const auto& given = joint.geometry.theta_dot_start;
        motion.theta_dot[theta++] = given ? *given : angle_rate(joint, start_state(mechanism), motion);
    }
    return motion;
}

AngleMeasure angle_of(const Joint& joint) {
    return {joint.geometry.s_i_local.normalized(), joint.geometry.u_i_local, joint.geometry.u_j_local};
}

DisplacementMeasure displacement_of(const Joint& joint) {
    return {joint.geometry.s_i_local.normalized(), joint.geometry.P_i_local, joint.geometry.P_j_local};
}

namespace {

/// The two bodies of a joint and its axis at a state.
struct PlacedAxis {
    PlacedAxis(const Joint& joint, const State& state)
        : i(at(joint.body_i)),
          j(at(joint.body_j)),
          A_i(homogeneous_rotation_matrix(state.p[i])),
          A_j(homogeneous_rotation_matrix(state.p[j])),
          s_i(A_i * joint.geometry.s_i_local.normalized()) {}

    /// ω_j - ω_i of a motion, or the difference of ω̇.
    Vec3 relative(const Motion& motion) const {
        return A_j * motion.omega_local[j] - A_i * motion.omega_local[i];
    }

    std::size_t i;
    std::size_t j;
    Mat3 A_i;
    Mat3 A_j;
    Vec3 s_i;
};

}  // namespace

double relative_angle(const Joint& joint, const State& state) {
    const PlacedAxis axis(joint, state);
    const Vec3 u_i = axis.A_i * joint.geometry.u_i_local;
    const Vec3 u_j = axis.A_j * joint.geometry.u_j_local;
    return elementary::atan2(u_i.cross(u_j).dot(axis.s_i), u_i.dot(u_j));
}

double screw_angle(const Joint& joint, const State& state) {
    const double angle = relative_angle(joint, state);
    const JointGeometry& g = joint.geometry;
    if (g.alpha == 0.0) { return angle; }
    const PlacedAxis axis(joint, state);
    const Vec3 d = state.r[axis.j] + axis.A_j * g.P_j_local - state.r[axis.i] - axis.A_i * g.P_i_local;
    const double by_advance = g.theta_0 + (axis.s_i.dot(d) - g.d_0) / g.alpha;
    constexpr double turn = 2.0 * std::numbers::pi;
    return angle + turn * std::round((by_advance - angle) / turn);
}

double angle_rate(const Joint& joint, const State& state, const Motion& motion) {
    const PlacedAxis axis(joint, state);
    return axis.s_i.dot(axis.relative(motion));
}

double angle_acceleration(
    const Joint& joint, const State& state, const Motion& motion, const Motion& acceleration) {
    const PlacedAxis axis(joint, state);
    const Vec3 omega_i = axis.A_i * motion.omega_local[axis.i];
    return axis.s_i.dot(axis.relative(acceleration)) + omega_i.cross(axis.s_i).dot(axis.relative(motion));
}

namespace {

/// Neither body can move away from the other.
bool ties(const Joint& joint) { return joint.type->uses(Role::same_point) || joint.type->uses(Role::length); }

/// Bodies that cannot move away from the fixed ones, whatever their start poses.
std::vector<bool> tied_bodies(const Mechanism& mechanism) {
    std::vector<bool> tied;
    for (const Body& body : mechanism.bodies) { tied.push_back(body.fixed); }
    for (bool grown = true; grown;) {
        grown = false;
        for (const Joint& joint : mechanism.joints) {
            const std::size_t i = at(joint.body_i);
            const std::size_t j = at(joint.body_j);
            if (!ties(joint) || tied[i] == tied[j]) { continue; }
            tied[i] = tied[j] = true;
            grown = true;
        }
    }
    return tied;
}

}  // namespace

double extent(const Mechanism& mechanism) {
    double largest = 0.0;
    double reach = 0.0;  // of a chain of all tied bodies
    for (const Joint& joint : mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        largest = std::max({largest, g.P_i_local.norm(), g.P_j_local.norm(), g.length});
        if (ties(joint)) { reach += g.P_i_local.norm() + g.P_j_local.norm() + g.length; }
    }
    const Vec3& origin = mechanism.bodies.front().r;
    double farthest_fixed = 0.0;
    double farthest = 0.0;
    for (const Body& body : mechanism.bodies) {
        farthest = std::max(farthest, (body.r - origin).norm());
        if (body.fixed) { farthest_fixed = std::max(farthest_fixed, (body.r - origin).norm()); }
    }
    reach += farthest_fixed;
    if (farthest <= std::max(largest, reach)) {
        largest = std::max(largest, farthest);
        return largest > 0.0 ? largest : 1.0;
    }
    // a start estimate beyond the reach of its joints says nothing about the size of the mechanism
    const std::vector<bool> tied = tied_bodies(mechanism);
    for (std::size_t b = 0; b < tied.size(); ++b) {
        const double distance = (mechanism.bodies[b].r - origin).norm();
        largest = std::max(largest, tied[b] ? std::min(distance, reach) : distance);
    }
    return largest > 0.0 ? largest : 1.0;
}

double unit_of_length(const Mechanism& mechanism) {
    return elementary::pow(1000.0, std::round(elementary::log10(extent(mechanism)) / 3.0));
}

}  // namespace jw
