#include "core/motion/loads.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Cholesky>

#include "core/model/joint_types.hpp"
#include "core/motion/forces.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

void require_mass(const Body& body, const std::optional<MassProperties>& mass) {
    if (!mass) { throw std::invalid_argument("moving body '" + body.name + "' has no mass"); }
    if (!(mass->mass > 0.0) || mass->J_local.llt().info() != Eigen::Success) {
        throw std::invalid_argument(
            "mass and inertia of body '" + body.name + "' must be positive (definite)");
    }
}

/// Converts a coordinate of the origin of a body as given to one of its centroidal frame.
Measure moved(const CoordinateMeasure& m, const Vec3& centre) {
    if (m.coordinate >= 3 || centre.isZero()) { return m; }
    throw std::invalid_argument(
        "a coordinate driver needs a body whose centre of mass is its origin; drive a displacement instead");
}

void move(Measure& measure, const Vec3& centre_i, const Vec3& centre_j) {
    measure = std::visit(
        Overloaded{
            [](const AngleMeasure& m) -> Measure { return m; },
            [](const ThetaMeasure& m) -> Measure { return m; },
            [&](DisplacementMeasure m) -> Measure {
                m.B_i_local -= centre_i;
                m.B_j_local -= centre_j;
                return m;
            },
            [&](SquaredDistanceMeasure m) -> Measure {
                m.P_i_local -= centre_i;
                m.P_j_local -= centre_j;
                return m;
            },
            [&](const CoordinateMeasure& m) { return moved(m, centre_j); },
        },
        measure);
}

}  // namespace

Loads without_friction(Loads loads) {
    for (Spring& spring : loads.springs) { spring.friction = {}; }
    for (RotationalSpring& spring : loads.rotational_springs) { spring.friction = {}; }
    return loads;
}

bool acts_about(const RotationalSpring& spring, const Joint& joint) {
    if (!joint.type->has_angle()) { return false; }
    const AngleMeasure angle = angle_of(joint);
    return joint.body_i == spring.body_i && joint.body_j == spring.body_j &&
           angle.s_i_local == spring.angle.s_i_local && angle.u_i_local == spring.angle.u_i_local &&
           angle.u_j_local == spring.angle.u_j_local;
}

bool acts_along(const Spring& spring, const Joint& joint) {
    if (!spring.s_i_local || !joint.type->has_displacement()) { return false; }
    const DisplacementMeasure displacement = displacement_of(joint);
    return joint.body_i == spring.body_i && joint.body_j == spring.body_j &&
           displacement.s_i_local == *spring.s_i_local && displacement.B_i_local == spring.P_i_local &&
           displacement.B_j_local == spring.P_j_local;
}

Centroidal centroidal(const Mechanism& mechanism, const Loads& loads) {
    Centroidal out{mechanism, loads, std::vector<Vec3>(mechanism.bodies.size(), Vec3::Zero())};
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        Body& body = out.mechanism.bodies[b];
        if (body.fixed) { continue; }
        require_mass(body, loads.masses[b]);
        out.centres[b] = loads.masses[b]->centre_local;
        out.loads.masses[b]->centre_local.setZero();
    }
    const auto centre = [&](int body) -> const Vec3& { return out.centres[at(body)]; };
    for (Joint& joint : out.mechanism.joints) {
        joint.geometry.P_i_local -= centre(joint.body_i);
        joint.geometry.P_j_local -= centre(joint.body_j);
        joint.geometry.O_i_local -= centre(joint.body_i);
        joint.geometry.O_j_local -= centre(joint.body_j);
    }
    for (Driver& driver : out.mechanism.drivers) {
        move(driver.measure, centre(driver.body_i), centre(driver.body_j));
    }
    for (AppliedForce& force : out.loads.forces) { force.point_local -= centre(force.body); }
    const auto shift = [&](auto& ends) {
        ends.P_i_local -= centre(ends.body_i);
        ends.P_j_local -= centre(ends.body_j);
    };
    std::ranges::for_each(out.loads.springs, shift);
    for_each_measuring<Spring>(out.loads, shift);
    std::ranges::for_each(out.loads.bushings, shift);
    // start estimates too: r + A c and its velocity
    const State start = start_state(mechanism);
    begin_turns(out.loads, kinematics_of(start));
    const Motion motion = start_motion(mechanism);
    const State moved_start = out.to_centroidal(start);
    const Motion moved_motion = out.to_centroidal(start, motion);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        out.mechanism.bodies[b].r = moved_start.r[b];
        out.mechanism.bodies[b].r_dot = moved_motion.r_dot[b];
    }
    return out;
}

State Centroidal::to_centroidal(const State& state) const {
    State out = state;
    for (std::size_t b = 0; b < centres.size(); ++b) {
        out.r[b] += homogeneous_rotation_matrix(state.p[b]) * centres[b];
    }
    return out;
}

Motion Centroidal::to_centroidal(const State& state, const Motion& motion) const {
    Motion out = motion;
    for (std::size_t b = 0; b < centres.size(); ++b) {
        out.r_dot[b] += homogeneous_rotation_matrix(state.p[b]) * motion.omega_local[b].cross(centres[b]);
    }
    return out;
}

State Centroidal::as_given(const State& centroidal) const {
    State out = centroidal;
    for (std::size_t b = 0; b < centres.size(); ++b) {
        out.r[b] -= homogeneous_rotation_matrix(centroidal.p[b]) * centres[b];
    }
    return out;
}

Motion Centroidal::as_given(const State& centroidal, const Motion& motion) const {
    Motion out = motion;
    for (std::size_t b = 0; b < centres.size(); ++b) {
        out.r_dot[b] -=
            homogeneous_rotation_matrix(centroidal.p[b]) * motion.omega_local[b].cross(centres[b]);
    }
    return out;
}

Motion Centroidal::acceleration_as_given(
    const State& centroidal, const Motion& velocity, const Motion& acceleration) const {
    Motion out = acceleration;
    for (std::size_t b = 0; b < centres.size(); ++b) {
        const Vec3& omega_local = velocity.omega_local[b];
        const Vec3 relative =
            acceleration.omega_local[b].cross(centres[b]) + omega_local.cross(omega_local.cross(centres[b]));
        out.r_dot[b] -= homogeneous_rotation_matrix(centroidal.p[b]) * relative;
    }
    return out;
}

}  // namespace jw
