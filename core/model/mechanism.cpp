#include "core/model/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "core/jets/body_kinematics.hpp"

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

State start_poses(const Mechanism& mechanism) {
    State state;
    for (const Body& body : mechanism.bodies) {
        state.r.push_back(body.r);
        state.p.push_back(body.p);
    }
    state.theta.assign(at(mechanism.thetas_count()), 0.0);
    return state;
}

State start_state(const Mechanism& mechanism) {
    State state = start_poses(mechanism);
    std::size_t theta = 0;
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        const auto& given = joint.geometry.theta_start;
        state.theta[theta++] = given ? *given : artificial_angle(joint, state);
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
    const State start = motion.theta_dot.empty() ? State{} : start_state(mechanism);
    std::size_t theta = 0;
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        const auto& given = joint.geometry.theta_dot_start;
        motion.theta_dot[theta] = given ? *given : artificial_rate(joint, start, motion, start.theta[theta]);
        ++theta;
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

constexpr double kTurn = 2.0 * std::numbers::pi;

std::optional<Wheel> wheel_of(const Joint& joint, bool (*is_meant)(Role)) {
    const auto role = std::ranges::find_if(joint.type->roles, is_meant);
    if (role == joint.type->roles.end()) { return std::nullopt; }
    return std::get<Wheel>(primitive_of(*role, joint.geometry, joint.parallel_form));
}

BodyKinematics<OmegaLocal> body_at(int body, const State& state) {
    return kinematics_at<OmegaLocal>(state.r[at(body)], state.p[at(body)]);
}

BodyKinematics<OmegaLocal> body_at(int body, const State& state, const Motion& motion) {
    const std::size_t b = at(body);
    return kinematics_at<OmegaLocal>(state.r[b], state.p[b], motion.r_dot[b], motion.omega_local[b]);
}

bool is_on_curve(const Joint& joint) { return joint.type->has_curve(); }

/// d in the frame of body i [m].
Vec3 d_local(const Joint& joint, const State& state) {
    const auto i = body_at(joint.body_i, state);
    const auto j = body_at(joint.body_j, state);
    const JointGeometry& g = joint.geometry;
    return i.A.transpose() * (j.r + j.A * g.P_j_local - i.r) - g.P_i_local;
}

double angle_of_wheel(const Wheel& wheel, const Joint& joint, const State& state) {
    return measured<Content::jacobian>(
               wheel, body_at(joint.body_i, state), body_at(joint.body_j, state), Theta{})
        .value(0);
}

}  // namespace

std::optional<Wheel> first_wheel(const Joint& joint) { return wheel_of(joint, is_first_wheel); }
std::optional<Wheel> second_wheel(const Joint& joint) { return wheel_of(joint, is_second_wheel); }

double artificial_angle(const Joint& joint, const State& state) {
    if (is_on_curve(joint)) { return joint.geometry.curve.nearest(d_local(joint, state)); }
    const std::optional<Wheel> wheel = first_wheel(joint);
    return wheel ? angle_of_wheel(*wheel, joint, state) : relative_angle(joint, state);
}

double artificial_angle_near(const Joint& joint, const State& state, double expected) {
    if (is_on_curve(joint)) { return joint.geometry.curve.followed(d_local(joint, state), expected); }
    return expected + std::remainder(artificial_angle(joint, state) - expected, kTurn);
}

double artificial_angle_with_turns(const Joint& joint, const State& state) {
    const double angle = artificial_angle(joint, state);
    const JointGeometry& g = joint.geometry;
    if (const std::optional<Wheel> other = second_wheel(joint)) {
        return angle + kTurn * turns_of_mesh(angle_of_wheel(*other, joint, state) - g.ratio * angle, g.ratio);
    }
    if (g.alpha == 0.0 || is_on_curve(joint)) { return angle; }
    const PlacedAxis axis(joint, state);
    const Vec3 d = state.r[axis.j] + axis.A_j * g.P_j_local - state.r[axis.i] - axis.A_i * g.P_i_local;
    const double by_advance = g.theta_0 + (axis.s_i.dot(d) - g.d_0) / g.alpha;
    return angle + kTurn * std::round((by_advance - angle) / kTurn);
}

namespace {

/// Linear part of the acceleration of a measure whose jet is `linear`.
template <class J>
double part_of(const J& linear, const Joint& joint, const Motion& acceleration) {
    const auto part = [&](const auto& block, int body) {
        return block.template leftCols<3>().row(0).dot(acceleration.r_dot[at(body)]) +
               block.template rightCols<3>().row(0).dot(acceleration.omega_local[at(body)]);
    };
    return part(linear.block_i, joint.body_i) + part(linear.block_j, joint.body_j);
}

/// First time derivative of wᵀ d_local for a vector w; the second one if `acceleration` is given.
double along_curve(
    const Joint& joint, const Vec3& w, const State& state, const Motion& motion,
    const Motion* acceleration = nullptr) {
    const DisplacementMeasure measure{w, joint.geometry.P_i_local, joint.geometry.P_j_local};
    const auto i = body_at(joint.body_i, state, motion);
    const auto j = body_at(joint.body_j, state, motion);
    const auto moving = measured<Content::motion>(measure, i, j, Theta{});
    if (acceleration == nullptr) { return moving.rate(0); }
    return part_of(measured<Content::jacobian>(measure, i, j, Theta{}), joint, *acceleration) +
           moving.bias(0);
}

/// θ̇, or θ̈ if `acceleration` is given, of a point that stays on its curve: c_uᵀ (ḋ - c_u θ̇) = 0.
double rate_on_curve(
    const Joint& joint, const State& state, const Motion& motion, const Motion* acceleration, double theta) {
    const Curve& curve = joint.geometry.curve;
    const Curve::Point at_u = curve.at(curve.nearest(d_local(joint, state), theta));
    const double square = at_u.c_u.squaredNorm();
    const double rate = along_curve(joint, at_u.c_u, state, motion) / square;
    if (acceleration == nullptr) { return rate; }
    return (along_curve(joint, at_u.c_u, state, motion, acceleration) -
            at_u.c_u.dot(at_u.c_uu) * rate * rate) /
           square;
}

}  // namespace

double artificial_rate(const Joint& joint, const State& state, const Motion& motion, double theta) {
    if (is_on_curve(joint)) { return rate_on_curve(joint, state, motion, nullptr, theta); }
    const std::optional<Wheel> wheel = first_wheel(joint);
    if (!wheel) { return angle_rate(joint, state, motion); }
    const double rate =
        measured<Content::motion>(
            *wheel, body_at(joint.body_i, state, motion), body_at(joint.body_j, state, motion), Theta{})
            .rate(0);
    return std::isfinite(rate) ? rate : 0.0;
}

double artificial_acceleration(
    const Joint& joint, const State& state, const Motion& motion, const Motion& acceleration, double theta) {
    if (is_on_curve(joint)) { return rate_on_curve(joint, state, motion, &acceleration, theta); }
    const std::optional<Wheel> wheel = first_wheel(joint);
    if (!wheel) { return angle_acceleration(joint, state, motion, acceleration); }
    const auto i = body_at(joint.body_i, state, motion);
    const auto j = body_at(joint.body_j, state, motion);
    return part_of(measured<Content::jacobian>(*wheel, i, j, Theta{}), joint, acceleration) +
           measured<Content::motion>(*wheel, i, j, Theta{}).bias(0);
}

int turns_of_mesh(double turned, double ratio) {
    // wheels have fewer teeth than this, so that every pose is reached within this many turns
    constexpr int most = 1000;
    // [rad] that each further turn must save; less is rounding
    constexpr double per_turn = 1e-6;
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n <= most && per_turn * n < least; ++n) {
        for (const int k : {n, -n}) {
            const double left = std::remainder(turned - kTurn * ratio * k, kTurn);
            const double cost = std::abs(left) + per_turn * n;
            if (cost < least) {
                least = cost;
                best = k;
            }
        }
    }
    return best;
}

namespace {

/// True if neither body can move away from the other.
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
