#include "core/dynamics/block_equations.hpp"

namespace jw {

/// M⁻¹ Q of every body.
template <int B>
void BlockEquations<B>::evaluate_forces(double t, const double* y) {
    const Loads& loads = scene_->loads;
    const auto force_at = [&](int body) -> double* {
        const int moving = order_of_body_[at(body)];
        return moving < 0 ? nullptr : six_.data() + static_cast<std::ptrdiff_t>(moving) * 6;
    };
    const auto add = [&](int body, const Vec3& f, const Vec3& n_local) {
        double* q = force_at(body);
        if (q == nullptr) { return; }
        vec3(q) += f;
        vec3(q + 3) += n_local;
    };
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Vec3 omega_local = vec3(y + kNumbersPerBody * static_cast<std::ptrdiff_t>(m) + 10);
        auto f = vec3(&six_[6 * m]);
        auto n_local = vec3(&six_[6 * m + 3]);
        f = moving_[m].mass * loads.gravity;
        n_local = -omega_local.cross(moving_[m].J * omega_local);
    }
    for (const AppliedForce& force : loads.forces) {
        const Mat3& A = bodies_[at(force.body)].A;
        const Vec3 f = force.magnitude.at(t).f *
                       (force.frame == Frame::global ? force.direction : (A * force.direction).eval());
        add(force.body, f, force.point_local.cross(A.transpose() * f));
    }
    for (const AppliedTorque& torque : loads.torques) {
        const Mat3& A = bodies_[at(torque.body)].A;
        const Vec3 n = torque.magnitude.at(t).f * torque.direction;
        add(torque.body, Vec3::Zero(), torque.frame == Frame::local ? n : (A.transpose() * n).eval());
    }
    for (const Spring& spring : loads.springs) {
        const Kinematics6& i = bodies_[at(spring.body_i)];
        const Kinematics6& j = bodies_[at(spring.body_j)];
        const Vec3 d = j.r + j.A * spring.P_j_local - i.r - i.A * spring.P_i_local;
        const Vec3 d_dot = j.r_dot + j.A_dot * spring.P_j_local - i.r_dot - i.A_dot * spring.P_i_local;
        const double length = d.norm();
        if (length == 0.0) { continue; }  // no direction to pull in
        const Vec3 along = d / length;
        const double pull =
            spring.stiffness * (length - spring.free_length) + spring.damping * along.dot(d_dot);
        const Vec3 f = pull * along;
        add(spring.body_i, f, spring.P_i_local.cross(i.A.transpose() * f));
        add(spring.body_j, -f, -spring.P_j_local.cross(j.A.transpose() * f));
    }
    for (const RotationalSpring& spring : loads.rotational_springs) {
        const Kinematics6& i = bodies_[at(spring.body_i)];
        const Kinematics6& j = bodies_[at(spring.body_j)];
        const auto angle = measured<Content::motion>(spring.angle, i, j, Theta{});
        const double torque =
            -spring.stiffness * std::remainder(angle.value(0) - spring.free_angle, 2.0 * std::numbers::pi) -
            spring.damping * angle.rate(0);
        const Vec3 n = torque * (i.A * spring.angle.s_i_local);
        add(spring.body_i, Vec3::Zero(), -(i.A.transpose() * n));
        add(spring.body_j, Vec3::Zero(), j.A.transpose() * n);
    }
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        auto f = vec3(&six_[6 * m]);
        auto n_local = vec3(&six_[6 * m + 3]);
        f *= moving_[m].inverse_mass;
        n_local = (moving_[m].inverse_J * n_local).eval();
    }
}

template <int B>
double BlockEquations<B>::kinetic_energy(const double* y) const {
    double energy = 0.0;
    for (const MovingBody& body : moving_) {
        const Eigen::Map<const Vec3> r_dot(y + 7);
        const Eigen::Map<const Vec3> omega_local(y + 10);
        energy += 0.5 * (body.mass * r_dot.squaredNorm() + omega_local.dot(body.J * omega_local));
        y += kNumbersPerBody;
    }
    return energy;
}

template <int B>
double BlockEquations<B>::potential_energy(const double* y) const {
    double energy = 0.0;
    const auto point = [&](int body, const Vec3& s_local) -> Vec3 {
        const int moving = order_of_body_[at(body)];
        if (moving < 0) { return bodies_[at(body)].r + bodies_[at(body)].A * s_local; }
        const double* numbers = y + static_cast<std::ptrdiff_t>(moving) * kNumbersPerBody;
        return vec3(numbers) + rotation_matrix(vec4(numbers + 3).normalized()) * s_local;
    };
    for (const MovingBody& body : moving_) {
        energy -= body.mass * scene_->loads.gravity.dot(point(body.body, Vec3::Zero()));
    }
    for (const Spring& spring : scene_->loads.springs) {
        const double stretch =
            (point(spring.body_j, spring.P_j_local) - point(spring.body_i, spring.P_i_local)).norm() -
            spring.free_length;
        energy += 0.5 * spring.stiffness * stretch * stretch;
    }
    return energy;
}

template void BlockEquations<3>::evaluate_forces(double, const double*);
template void BlockEquations<6>::evaluate_forces(double, const double*);
template double BlockEquations<3>::kinetic_energy(const double*) const;
template double BlockEquations<6>::kinetic_energy(const double*) const;
template double BlockEquations<3>::potential_energy(const double*) const;
template double BlockEquations<6>::potential_energy(const double*) const;

}  // namespace jw
