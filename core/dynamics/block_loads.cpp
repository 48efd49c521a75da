#include "core/dynamics/block_equations.hpp"

namespace jw {

template <int B>
void BlockEquations<B>::evaluate_forces(double t, const double* y) {
    for (const MovingBody& body : moving_) { forces_[at(body.body)] = {}; }
    add_forces(scene_->loads, bodies_, t, forces_);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const BodyForce& force = forces_[at(moving_[m].body)];
        const Vec3 n_local = force.n_local + gyroscopic_torque(moving_[m].J, vec3(body_numbers(y, m) + 10));
        vec3(&six_[6 * m]) = moving_[m].inverse_mass * force.f;
        vec3(&six_[6 * m + 3]) = moving_[m].inverse_J * n_local;
    }
}

template <int B>
double BlockEquations<B>::kinetic_energy(const double* y) const {
    double energy = 0.0;
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double* velocity = body_numbers(y, m) + 7;
        energy += jw::kinetic_energy(
            *scene_->loads.masses[at(moving_[m].body)], vec3(velocity), vec3(velocity + 3));
    }
    return energy;
}

template <int B>
double BlockEquations<B>::potential_energy(const double* y) const {
    std::vector<Kinematics6> bodies = bodies_;
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        Kinematics6& body = bodies[at(moving_[m].body)];
        body.r = vec3(body_numbers(y, m));
        body.A = rotation_matrix(vec4(body_numbers(y, m) + 3).normalized());
    }
    return jw::potential_energy(scene_->loads, bodies);
}

template void BlockEquations<3>::evaluate_forces(double, const double*);
template void BlockEquations<5>::evaluate_forces(double, const double*);
template void BlockEquations<6>::evaluate_forces(double, const double*);
template double BlockEquations<3>::kinetic_energy(const double*) const;
template double BlockEquations<5>::kinetic_energy(const double*) const;
template double BlockEquations<6>::kinetic_energy(const double*) const;
template double BlockEquations<3>::potential_energy(const double*) const;
template double BlockEquations<5>::potential_energy(const double*) const;
template double BlockEquations<6>::potential_energy(const double*) const;

}  // namespace jw
