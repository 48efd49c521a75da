#include "core/poses/branches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "core/equations/assembler.hpp"
#include "core/jets/body_kinematics.hpp"

namespace jw {

namespace {

// a start pose does not determine the side if its side vectors are less than 6 deg from the plane that
// separates the sides
constexpr double kClearSide = 0.1;
// a lesson's numbers may close only to 1e-7; the pair kept by the rule passes on twice that
constexpr double kHolds = 1e-6;

const Joint& joint_of(const System& system, const Constraint& c) {
    return system.mechanism().joints[static_cast<std::size_t>(c.joint)];
}

Vec3 turned(const State& state, int body, const Vec3& s_local) {
    return rotation_matrix(state.p[static_cast<std::size_t>(body)]) * s_local;
}

/// Cosine of the angle between the two axes of p1.
double alignment(const Joint& joint, const State& state) {
    const Vec3 s_i = turned(state, joint.body_i, joint.geometry.s_i_local.normalized());
    return s_i.dot(turned(state, joint.body_j, joint.geometry.s_j_local.normalized()));
}

/// True if the axes of the constraint's joint are kept parallel; false where equations were removed by hand.
bool axes_held(const System& system, const Constraint& c, const State& state) {
    for (const Constraint& other : system.constraints()) {
        if (other.joint != c.joint || other.role != Role::axes_parallel || other.taken_out == 0) { continue; }
        if (other.rows() < 2) { return false; }
        // two rows chosen by hand do not constrain an axis that lies in their plane
        if (values_of(other, state).cwiseAbs().maxCoeff() > kHolds * other.unit) { return false; }
    }
    return true;
}

/// Cosine of the angle by which a joint's θ, or a wheel that follows it, differs from the pose of the bodies.
double cosine_of_theta(const Constraint& c, const Joint& joint, const State& state) {
    const double theta = state.theta[static_cast<std::size_t>(c.theta)];
    const auto* wheel = std::get_if<Wheel>(&c.primitive);
    if (wheel == nullptr) { return elementary::cos(relative_angle(joint, state) - theta); }
    const auto body = [&](int b) { return kinematics_at<OmegaLocal>(state.r[at(b)], state.p[at(b)]); };
    const auto angle = measured<Content::jacobian>(*wheel, body(c.body_i), body(c.body_j), Theta{});
    return elementary::cos(angle.value(0) - wheel->ratio * theta);
}

/// True for a constraint that two values of θ, half a turn apart, satisfy.
bool has_two_angles(const Constraint& c, const Joint& joint) {
    if (std::holds_alternative<Wheel>(c.primitive)) { return true; }
    return c.role == Role::screw_angle && joint.geometry.screw_angle_form == ScrewAngleForm::rotation;
}

/// Handedness (h_i x h_j)·s_i of unit vectors.
double handedness(const Joint& joint, const State& state) {
    const Vec3 h_i = turned(state, joint.body_i, joint.geometry.h_i_local.normalized());
    const Vec3 h_j = turned(state, joint.body_j, joint.geometry.h_j_local.normalized());
    return h_i.cross(h_j).dot(turned(state, joint.body_i, joint.geometry.s_i_local.normalized()));
}

void turn_half_about(const System& system, const Joint& joint, const Vec3& axis, State& state) {
    const auto& moving = system.mechanism().bodies;
    const bool turns_j = !moving[static_cast<std::size_t>(joint.body_j)].fixed;
    const auto body = static_cast<std::size_t>(turns_j ? joint.body_j : joint.body_i);
    const Vec3& point_local = turns_j ? joint.geometry.P_j_local : joint.geometry.P_i_local;

    const Vec3 point = state.r[body] + rotation_matrix(state.p[body]) * point_local;
    state.p[body] = turned_global(state.p[body], std::numbers::pi * axis.normalized());
    state.r[body] = point - rotation_matrix(state.p[body]) * point_local;
}

}  // namespace

std::vector<int> intended_sides(const System& system) {
    const State start = start_state(system.mechanism());
    std::vector<int> sides;
    for (const Constraint& c : system.constraints()) {
        int side = 0;
        if (c.role == Role::sides_perpendicular) {
            const double measure = handedness(joint_of(system, c), start);
            if (std::abs(measure) > kClearSide) { side = measure > 0.0 ? 1 : -1; }
        }
        sides.push_back(side);
    }
    return sides;
}

std::optional<WrongBranch> find_wrong_branch(
    const System& system, const State& state, const std::vector<int>& sides) {
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        const Joint& joint = joint_of(system, c);
        const int index = static_cast<int>(k);
        if (c.rows() == 0 || !axes_held(system, c, state)) { continue; }
        if (c.role == Role::axes_parallel) {
            const double cosine = alignment(joint, state);
            if (cosine < 0.0) { return WrongBranch{WrongBranch::Kind::anti_parallel, index, cosine}; }
        } else if (c.role == Role::sides_perpendicular && sides[k] != 0) {
            const double measure = sides[k] * handedness(joint, state);
            if (measure < 0.0) { return WrongBranch{WrongBranch::Kind::half_turn, index, measure}; }
        } else if (has_two_angles(c, joint)) {
            const double cosine = cosine_of_theta(c, joint, state);
            if (cosine < 0.0) { return WrongBranch{WrongBranch::Kind::screw_angle, index, cosine}; }
        }
    }
    return std::nullopt;
}

bool left_out_rows_hold(const System& system, const State& state) {
    for (const Constraint& c : system.constraints()) {
        if (c.dropped < 0 || c.taken_out != 0 || joint_of(system, c).parallel_form != ParallelForm::rule) {
            continue;
        }
        if (std::abs(values_of(c, state)(c.dropped)) > kHolds * c.unit) { return false; }
    }
    return true;
}

void leave_branch(const System& system, const WrongBranch& wrong, State& state) {
    const Constraint& c = system.constraints()[static_cast<std::size_t>(wrong.constraint)];
    const Joint& joint = joint_of(system, c);
    const Vec3 s_i = turned(state, joint.body_i, joint.geometry.s_i_local.normalized());
    switch (wrong.kind) {
        case WrongBranch::Kind::anti_parallel:
            turn_half_about(system, joint, perpendicular_to(s_i), state);
            break;
        case WrongBranch::Kind::half_turn: turn_half_about(system, joint, s_i, state); break;
        case WrongBranch::Kind::screw_angle: {
            if (is_second_wheel(c.role)) {
                turn_half_about(
                    system, joint, turned(state, joint.body_j, joint.geometry.s_j_local.normalized()), state);
                break;
            }
            double& theta = state.theta[static_cast<std::size_t>(c.theta)];
            theta = artificial_angle_near(joint, state, theta);
            break;
        }
    }
}

bool is_meant(const System& system, const State& state, const std::vector<int>& sides) {
    return !find_wrong_branch(system, state, sides) && left_out_rows_hold(system, state);
}

double largest_part(const System& system, const VectorX& columns, double length) {
    double largest = 0.0;
    for (const int body : system.moving_bodies()) {
        const int column = system.body_column(body, OmegaLocal::kAngular);
        largest = std::max(
            {largest, columns.segment<3>(column).norm() / length, columns.segment<3>(column + 3).norm()});
    }
    for (const int theta : system.active_thetas()) {
        largest = std::max(largest, std::abs(columns(system.theta_column(theta, OmegaLocal::kAngular))));
    }
    return largest;
}

double movement(const System& system, const State& from, const State& to) {
    double largest = 0.0;
    for (const int body : system.moving_bodies()) {
        const auto k = static_cast<std::size_t>(body);
        largest = std::max(
            {largest, (from.r[k] - to.r[k]).norm() / system.length_unit(),
             turn_local_between(from.p[k], to.p[k]).norm()});
    }
    return largest;
}

bool is_on_tangent(double step, double correction) {
    constexpr double largest_correction = 0.3;
    constexpr double no_movement = 1e-9;  // rounding
    return correction <= std::max(largest_correction * step, no_movement);
}

bool same_curve(
    const System& system, const State& from, const State& prediction, const State& reached,
    const std::vector<int>& sides) {
    const double step = movement(system, from, reached);
    const double correction = movement(system, prediction, reached);
    return is_on_tangent(step, correction) && is_meant(system, reached, sides);
}

}  // namespace jw
