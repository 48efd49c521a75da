#pragma once

#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/scenes.hpp"

/// Scenes with a driver, and their velocities and accelerations in one line.
namespace jw::test {

/// The joint's angle as start + rate t + acceleration t²/2, `start` being the angle that it has.
inline Mechanism driven(Mechanism mechanism, int joint, double rate, double acceleration = 0.0) {
    const double angle =
        relative_angle(mechanism.joints[static_cast<std::size_t>(joint)], start_state(mechanism));
    drive_angle(mechanism, joint, polynomial({angle, rate, 0.5 * acceleration}));
    return mechanism;
}

struct Analysis {
    VelocityOutcome velocity;
    AccelerationOutcome acceleration;
};

/// Analysis of all equations at an assembled state.
template <class C = OmegaLocal>
Analysis analyse(const Mechanism& mechanism, const State& state, double t = 0.0) {
    const System system(mechanism, everything(mechanism));
    Kinematics<C> kinematics(system);
    kinematics.set_state(state, t);
    VelocityOutcome velocity = kinematics.solve_velocity(zero_motion(mechanism));
    AccelerationOutcome acceleration = kinematics.solve_acceleration(velocity.velocity);
    return {std::move(velocity), std::move(acceleration)};
}

/// Angle of a joint with its rate and acceleration.
inline Measured joint_angle(
    const Mechanism& mechanism, int joint, const State& state, const Motion& velocity,
    const Motion& acceleration) {
    const Joint& j = mechanism.joints[static_cast<std::size_t>(joint)];
    return evaluate_measure(angle_of(j), j.body_i, j.body_j, -1, state, velocity, acceleration);
}
inline Measured joint_angle(
    const Mechanism& mechanism, int joint, const State& state, const Analysis& analysis) {
    return joint_angle(
        mechanism, joint, state, analysis.velocity.velocity, analysis.acceleration.acceleration);
}
inline Measured joint_angle(const Mechanism& mechanism, int joint, const MotionFrame& frame) {
    return joint_angle(mechanism, joint, frame.state, frame.velocity, frame.acceleration);
}

/// Largest difference of ṙ, ω′ and θ̇ over all bodies.
inline double difference(const Motion& a, const Motion& b) {
    double largest = 0.0;
    for (std::size_t k = 0; k < a.r_dot.size(); ++k) {
        largest = std::max(
            {largest, (a.r_dot[k] - b.r_dot[k]).norm(), (a.omega_local[k] - b.omega_local[k]).norm()});
    }
    for (std::size_t k = 0; k < a.theta_dot.size(); ++k) {
        largest = std::max(largest, std::abs(a.theta_dot[k] - b.theta_dot[k]));
    }
    return largest;
}

}  // namespace jw::test
