#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/jets/coordinates.hpp"
#include "core/motion/loads.hpp"

/// Forces and torques of the loads on every body, shared by all forms of the equations of motion.
namespace jw {

/// Force and torque on a body.
struct BodyForce {
    Vec3 f = Vec3::Zero();        ///< [N], global, through the centre of mass
    Vec3 n_local = Vec3::Zero();  ///< about the centre of mass [N m], body frame
};

/// Kinematics of every body at a state, without motion.
std::vector<BodyKinematics<OmegaLocal>> kinematics_of(const State& state);
/// Kinematics of every body, with its motion.
std::vector<BodyKinematics<OmegaLocal>> kinematics_of(const State& state, const Motion& motion);

/// Vector from a spring's end on body i to its end on body j [m], global, and its rate [m/s].
struct SpringSpan {
    Vec3 d;
    Vec3 d_dot;
};
SpringSpan span_of(const Spring& spring, std::span<const BodyKinematics<OmegaLocal>> bodies);

/// What a law adds to the magnitude of its load at time `t` [s]: [N] or [N m].
double value_of(const LoadLaw& law, std::span<const BodyKinematics<OmegaLocal>> bodies, double t);

/// Size of the terms whose difference is the force of a spring [N], or its torque [N m], or the value of a
/// law: rounding of the force is relative to it. Turns of the rotational spring are counted up to this state.
double size_of(const Spring& spring, std::span<const BodyKinematics<OmegaLocal>> bodies, double t);
double size_of(const RotationalSpring& spring, double t);
double size_of(const LoadLaw& law, std::span<const BodyKinematics<OmegaLocal>> bodies, double t);
/// Size of the terms of a bushing's force and torque, with torques divided by a length [N].
double size_of(const Bushing& bushing, std::span<const BodyKinematics<OmegaLocal>> bodies, double length);

/// Replaces the laws of all loads by their first-order expansions about these poses and time `t` [s]. The
/// time stands still.
/// @param bodies  at rest
/// @return false if a law has no slope there, or a kink so near that rounding hides on which side it is
bool linearise_laws(Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies, double t);

/// Source of a law whose value or derivative is not bounded near a state and a time `t` [s]; empty if there
/// is none.
/// @param derivative  0: the value alone; 1: also its slopes
/// @param beside      distance of the numbers from those of the state, relative to these beyond 1
std::string unbounded_law(
    const Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies, double t, std::size_t derivative,
    double beside);

/// Laws that depend on the time, as functions of the time alone: of bodies that stay at these poses.
std::vector<ScalarFormula> laws_in_time(
    const Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies);

/// Adds gravity, forces, torques, springs and dampers at time `t` [s]. Allocates nothing.
/// @param loads centroidal, see Centroidal
/// @param bodies one per body of the mechanism, fixed ones included, with their motion set
/// @param forces one per body; forces on fixed bodies are added too
void add_forces(
    const Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies, double t,
    std::span<BodyForce> forces);

/// Starts the count of turns of rotational springs. A free angle within half a turn is an angle of the joint:
/// the spring is twisted by at most half a turn, in the shorter direction. A free angle beyond half a turn
/// includes turns: the spring is twisted by the whole difference between it and the angle of the joint in
/// (-π, π].
void begin_turns(Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies);

/// Continues the count of turns of rotational springs at these poses. Consecutive states must lie less than
/// half a turn of any spring apart.
void count_turns(Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies);

/// Gyroscopic torque -ω̃'J'ω' of Q [N m], body frame.
/// @source slide 24
inline Vec3 gyroscopic_torque(const Mat3& J_local, const Vec3& omega_local) {
    return -omega_local.cross(J_local * omega_local);
}

/// Kinetic energy of one body whose frame lies at its centre of mass [J].
inline double kinetic_energy(const MassProperties& own, const Vec3& r_dot, const Vec3& omega_local) {
    return 0.5 * (own.mass * r_dot.squaredNorm() + omega_local.dot(own.J_local * omega_local));
}

/// Kinetic and potential energy of a scene.
struct Energy {
    double kinetic = 0.0;    ///< [J]
    double potential = 0.0;  ///< potential energy of gravity and of all springs [J]
};
/// Energies at a state and a motion of the centroidal frames.
Energy energy_of(const Centroidal& scene, const State& state, const Motion& motion);

/// Potential energy of gravity and of all springs [J]; applied forces and torques have none, nor have laws
/// that depend on the time. The energy of another law is its work at rest, from the free length or angle on.
double potential_energy(const Loads& loads, std::span<const BodyKinematics<OmegaLocal>> bodies);

}  // namespace jw
