#include "core/motion/dense/dense_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/jets/body_kinematics.hpp"

namespace jw {

namespace {

template <class C>
Vec4 p_dot_of_numbers(const Vec4& p, const Eigen::Matrix<double, C::kAngular, 1>& angular) {
    if constexpr (C::kNormalised) {
        return angular;
    } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
        return p_dot_of_omega_global(p, angular);
    } else {
        return p_dot_of_omega_local(p, angular);
    }
}

/// H with ω' = H times the angular numbers: M and Q of a choice are Hᵀ J' H and Hᵀ n'.
template <class C>
Eigen::Matrix<double, 3, C::kAngular> turning_of(const BodyKinematics<OmegaLocal>& body) {
    if constexpr (C::kNormalised) {
        return 2.0 * L_of(body.p);
    } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
        return body.A.transpose();
    } else {
        return Mat3::Identity();
    }
}

}  // namespace

template <class C>
DenseEquations<C>::DenseEquations(const Centroidal& scene, const Baumgarte& baumgarte)
    : scene_(&scene),
      baumgarte_(baumgarte),
      system_(scene.mechanism, everything(scene.mechanism)),
      assembler_(system_),
      saddle_point_(scaling_of<C>(system_)),
      system_before_(system_),
      state_(start_state(scene.mechanism)),
      motion_(zero_motion(scene.mechanism)),
      velocity_(VectorX::Zero(assembler_.layout().columns())),
      bodies_(scene.mechanism.bodies.size()),
      forces_(scene.mechanism.bodies.size()),
      mass_(MatrixX::Zero(velocity_.size(), velocity_.size())),
      force_(VectorX::Zero(velocity_.size())) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        bodies_[b].r = state_.r[b];
        bodies_[b].p = state_.p[b];
        bodies_[b].A = homogeneous_rotation_matrix(state_.p[b]);
    }
    std::vector<double> y(at(size()));
    pack(state_, motion_, y.data());
    choose_rows(0.0, y.data());
}

template <class C>
void DenseEquations<C>::pack(const State& state, const Motion& motion, double* y) const {
    for (const int b : system_.moving_bodies()) {
        const Vec4& p = state.p[at(b)];
        Eigen::Map<Eigen::Matrix<double, kNumbers, 1>>(y) << state.r[at(b)], p, motion.r_dot[at(b)],
            angular_of<C>(p, motion.omega_local[at(b)]);
        y += kNumbers;
    }
}

template <class C>
void DenseEquations<C>::unpack(const double* y, State& state, Motion& motion) const {
    for (const int b : system_.moving_bodies()) {
        const Eigen::Map<const Eigen::Matrix<double, kNumbers, 1>> numbers(y);
        state.r[at(b)] = numbers.template head<3>();
        state.p[at(b)] = numbers.template segment<4>(3);
        motion.r_dot[at(b)] = numbers.template segment<3>(7);
        motion.omega_local[at(b)] =
            omega_local_of_angular<C>(state.p[at(b)], numbers.template tail<C::kAngular>());
        y += kNumbers;
    }
}

template <class C>
void DenseEquations<C>::to_flat(const double* y, double* flat) const {
    for (std::size_t n = 0; n < system_.moving_bodies().size(); ++n) {
        const Eigen::Map<const Eigen::Matrix<double, kNumbers, 1>> numbers(y + n * kNumbers);
        Eigen::Map<Eigen::Matrix<double, kNumbersPerBody, 1>>(body_numbers(flat, n))
            << numbers.template head<10>(),
            omega_local_of_angular<C>(vec4(numbers.data() + 3), numbers.template tail<C::kAngular>());
    }
}

/// Rates of the flat state. ω̇' follows from p̈ and ω̇ as ω' follows from ṗ and ω (slide 13).
template <class C>
void DenseEquations<C>::flat_rates(const double* y, const double* y_dot, double* flat_dot) const {
    for (std::size_t n = 0; n < system_.moving_bodies().size(); ++n) {
        const Eigen::Map<const Eigen::Matrix<double, kNumbers, 1>> rates(y_dot + n * kNumbers);
        Eigen::Map<Eigen::Matrix<double, kNumbersPerBody, 1>>(body_numbers(flat_dot, n))
            << rates.template head<10>(),
            omega_local_of_angular<C>(vec4(y + n * kNumbers + 3), rates.template tail<C::kAngular>());
    }
}

template <class C>
void DenseEquations<C>::derivatives(const double* y, const double* y_dot, double* out) const {
    std::vector<double> flat(static_cast<std::size_t>(kNumbersPerBody * bodies()));
    std::vector<double> flat_dot(flat.size());
    to_flat(y, flat.data());
    flat_rates(y, y_dot, flat_dot.data());
    flat_derivatives(flat.data(), flat_dot.data(), bodies(), out);
}

template <class C>
void DenseEquations<C>::motion_of_bodies(
    double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies) {
    std::vector<double> flat(static_cast<std::size_t>(kNumbersPerBody) * bodies.size());
    std::vector<double> flat_dot(flat.size());
    to_flat(y, flat.data());
    flat_rates(y, y_dot, flat_dot.data());
    MotionEquations::motion_of_bodies(t, flat.data(), flat_dot.data(), bodies);
}

template <class C>
void DenseEquations<C>::from_flat(const double* flat, double* y) const {
    for (std::size_t n = 0; n < system_.moving_bodies().size(); ++n) {
        const double* numbers = body_numbers(flat, n);
        Eigen::Map<Eigen::Matrix<double, kNumbers, 1>>(y + n * kNumbers)
            << Eigen::Map<const Eigen::Matrix<double, 10, 1>>(numbers),
            angular_of<C>(vec4(numbers + 3), vec3(numbers + 10));
    }
}

template <class C>
void DenseEquations<C>::state_of(const double* value, const double* rate, double* y) const {
    std::vector<double> flat(static_cast<std::size_t>(kNumbersPerBody * bodies()));
    flat_state_of(value, rate, bodies(), flat.data());
    from_flat(flat.data(), y);
}

/// Finds every θ, the angle that it follows with the turns nearest to its previous value, and θ̇.
template <class C>
void DenseEquations<C>::find_thetas() {
    std::size_t theta = 0;
    for (const Joint& joint : scene_->mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        double& value = state_.theta[theta];
        value = artificial_angle_near(joint, state_, value);
        motion_.theta_dot[theta] = artificial_rate(joint, state_, motion_, value);
        ++theta;
    }
}

template <class C>
void DenseEquations<C>::read(const double* y) {
    unpack(y, state_, motion_);
    for (const int b : system_.moving_bodies()) {
        BodyKinematics<OmegaLocal>& body = bodies_[at(b)];
        body.r = state_.r[at(b)];
        body.p = state_.p[at(b)];
        body.A = homogeneous_rotation_matrix(body.p);
        body.r_dot = motion_.r_dot[at(b)];
        OmegaLocal::set_motion(body, motion_.omega_local[at(b)]);
    }
    find_thetas();
    velocity_ = assembler_.layout().columns_of(state_, motion_);
}

template <class C>
void DenseEquations<C>::set_mass() {
    for (const int b : system_.moving_bodies()) {
        const MassProperties& m = *scene_->loads.masses[at(b)];
        const int column = system_.body_column(b, C::kAngular);
        const auto H = turning_of<C>(bodies_[at(b)]);
        mass_.block<3, 3>(column, column) = m.mass * Mat3::Identity();
        mass_.block<C::kAngular, C::kAngular>(column + 3, column + 3) = H.transpose() * m.J_local * H;
    }
}

template <class C>
void DenseEquations<C>::set_force(double t) {
    std::ranges::fill(forces_, BodyForce{});
    add_forces(scene_->loads, bodies_, t, forces_);
    for (const int b : system_.moving_bodies()) {
        const int column = system_.body_column(b, C::kAngular);
        const Mat3& J = scene_->loads.masses[at(b)]->J_local;
        const Vec3 n_local = forces_[at(b)].n_local + gyroscopic_torque(J, motion_.omega_local[at(b)]);
        force_.segment<3>(column) = forces_[at(b)].f;
        force_.segment<C::kAngular>(column + 3) = turning_of<C>(bodies_[at(b)]).transpose() * n_local;
    }
}

template <class C>
RowsVerdict DenseEquations<C>::evaluate(double t, const double* y, double* y_dot) {
    read(y);
    assembler_.assemble_phi_and_jacobian(state_, t);
    assembler_.assemble_nu(t);
    assembler_.assemble_gamma(state_, motion_, t);
    set_mass();
    set_force(t);

    const VectorX phi_dot = jacobian() * velocity_ - assembler_.nu();
    right_ = assembler_.gamma() - 2.0 * baumgarte_.alpha * phi_dot -
             baumgarte_.beta * baumgarte_.beta * assembler_.phi();
    saddle_point_.factor(mass_, jacobian());
    saddle_point_.solve(force_, right_, acceleration_, lambda_);

    for (const int b : system_.moving_bodies()) {
        const Eigen::Map<const Eigen::Matrix<double, kNumbers, 1>> numbers(y);
        const Angular<C> angular = numbers.template tail<C::kAngular>();
        Eigen::Map<Eigen::Matrix<double, kNumbers, 1>>(y_dot) << numbers.template segment<3>(7),
            p_dot_of_numbers<C>(state_.p[at(b)], angular),
            acceleration_.segment<3 + C::kAngular>(system_.body_column(b, C::kAngular));
        y += kNumbers;
        y_dot += kNumbers;
    }
    return {saddle_point_.smallest_pivot(), largest_of_kept_rows(assembler_.phi())};
}

template class DenseEquations<TrueEulerParameters>;
template class DenseEquations<ModifiedEulerParameters>;
template class DenseEquations<OmegaLocal>;
template class DenseEquations<OmegaGlobal>;

std::unique_ptr<MotionEquations> dense_equations(
    const Centroidal& scene, CoordinateChoice choice, const Baumgarte& baumgarte) {
    return with_choice(choice, [&](auto c) -> std::unique_ptr<MotionEquations> {
        return std::make_unique<DenseEquations<decltype(c)>>(scene, baumgarte);
    });
}

}  // namespace jw
