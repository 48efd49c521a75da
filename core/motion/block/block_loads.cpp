#include "core/motion/block/block_equations.hpp"

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

template void BlockEquations<3>::evaluate_forces(double, const double*);
template void BlockEquations<5>::evaluate_forces(double, const double*);
template void BlockEquations<6>::evaluate_forces(double, const double*);

}  // namespace jw
