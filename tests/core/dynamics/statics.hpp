#pragma once

#include "core/statics/equilibrium.hpp"
#include "tests/support/random_dynamics.hpp"

/// Scenes and searches that tests of equilibria share.
namespace jw::test {

inline constexpr double kG = 9.81;

inline RestOutcome found(const Centroidal& scene, Seek seek = Seek::where_it_rests) {
    return find_equilibrium(scene, start_state(scene.mechanism), 0.0, seek);
}

/// Rods of 1 m and mass 1 kg at their far ends, whose inertia about it is `J`, hinged in a row about y;
/// `angles` from the downward direction.
inline SceneBuilder row_of_rods(const std::vector<double>& angles) {
    SceneBuilder scene;
    Vec3 end = Vec3::Zero();
    int last = 0;
    for (const double angle : angles) {
        const Vec3 next = end + Vec3(std::sin(angle), 0.0, -std::cos(angle));
        const int rod = scene.add_body("rod", next);
        scene.add_joint("revolute", last, rod, end, Vec3::UnitY());
        last = rod;
        end = next;
    }
    return scene;
}
inline Loads point_masses(const Mechanism& mechanism, double mass, double J) {
    Loads loads;
    loads.gravity = -kG * Vec3::UnitZ();
    loads.masses.assign(mechanism.bodies.size(), MassProperties{mass, Vec3::Zero(), J * Mat3::Identity()});
    loads.masses.front().reset();
    return loads;
}

/// The mechanism at a state and a motion of its frames.
inline Mechanism placed(Mechanism mechanism, const State& state, const Motion& motion) {
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        mechanism.bodies[b].r = state.r[b];
        mechanism.bodies[b].p = state.p[b];
        mechanism.bodies[b].r_dot = motion.r_dot[b];
        mechanism.bodies[b].omega_local = motion.omega_local[b];
    }
    return mechanism;
}

inline State moved(State state, const Motion& by, double size) {
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        state.r[b] += size * by.r_dot[b];
        state.p[b] = turned_local(state.p[b], size * by.omega_local[b]);
    }
    for (std::size_t k = 0; k < state.theta.size(); ++k) { state.theta[k] += size * by.theta_dot[k]; }
    return state;
}

}  // namespace jw::test
