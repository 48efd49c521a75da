#include "lessons/formula/part_values.hpp"

#include <algorithm>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/equations/assembler.hpp"
#include "core/jets/body_kinematics.hpp"

namespace jw::formula {

namespace {

Value still(const MatrixX& value) {
    Value v = constant(value);
    v.order = 0;
    return v;
}

/// Forces of the loads on every body.
std::vector<BodyForce> forces_at(const Instant& instant) {
    std::vector<BodyKinematics<OmegaLocal>> bodies;
    for (std::size_t b = 0; b < instant.state.r.size(); ++b) {
        bodies.push_back(kinematics_at<OmegaLocal>(
            instant.state.r[b], instant.state.p[b], instant.velocity.r_dot[b],
            instant.velocity.omega_local[b]));
    }
    std::vector<BodyForce> forces(bodies.size());
    add_forces(instant.scene->loads, bodies, instant.t, forces);
    return forces;
}

double largest(const VectorX& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

bool has_centred_masses(const Instant& instant) {
    return instant.scene &&
           std::ranges::all_of(instant.scene->centres, [](const Vec3& c) { return c.isZero(0.0); });
}

/// The mechanism in one coordinate choice.
template <class C>
class SystemAt {
public:
    explicit SystemAt(const Instant& instant)
        : instant_(&instant), system_(instant.system.get()), assembler_(*instant.system) {
        assembler_.assemble_phi_and_jacobian(instant.state, instant.t);
        assembler_.assemble_nu(instant.t);
        assembler_.assemble_gamma(instant.state, instant.velocity, instant.t);
    }

    std::optional<Value> value(const Symbol& symbol) {
        const std::string name = name_of(symbol);
        if (name == "Φ") { return phi(); }
        if (name == "Φ_q") { return still(assembler_.jacobian()); }
        if (name == "Φ_t") { return still(-assembler_.nu()); }
        if (name == "γ" || name == "γ^#" || name == "γ^(m)") { return still(assembler_.gamma()); }
        if (name == "q") { return coordinates(); }
        if (!has_centred_masses(*instant_)) { return std::nullopt; }
        if (name == "M") { return still(mass_matrix()); }
        if (name == "Q") { return still(forces()); }
        if (name == "λ" && instant_->acceleration) { return still(multipliers()); }
        return std::nullopt;
    }

private:
    /// Φ and its derivatives; its rate is Φq q̇ + Φ_t, which only the equations of motion make zero.
    Value phi() {
        const MatrixX& jacobian = assembler_.jacobian();
        const VectorX rate = jacobian * columns(1) - assembler_.nu();
        const bool accelerated = instant_->acceleration.has_value();
        const VectorX second = accelerated ? VectorX(jacobian * columns(2) - assembler_.gamma()) : rate;
        Value phi = moving(assembler_.phi(), rate, second, accelerated ? 2 : 1);
        // values of 0 are sums of terms that are not 0
        for (int row = 0; row < system_->rows(); ++row) {
            phi.scale[0] = std::max(phi.scale[0], system_->row_unit(row));
        }
        const double steepest = jacobian.size() == 0 ? 0.0 : jacobian.cwiseAbs().maxCoeff();
        phi.scale[1] = std::max(phi.scale[1], steepest * largest(columns(1)));
        if (accelerated) {
            phi.scale[2] =
                std::max({phi.scale[2], steepest * largest(columns(2)), largest(assembler_.gamma())});
        }
        return phi;
    }

    /// q and its derivatives. In the choices of ω, orientations are not coordinates: their entries are 0.
    Value coordinates() {
        const VectorX values = columns(0);
        return moving(
            values, columns(1), instant_->acceleration ? columns(2) : values, instant_->acceleration ? 2 : 1);
    }

    /// q, q̇ or q̈ of the moving bodies and of the artificial coordinates.
    VectorX columns(int order) const {
        VectorX all = VectorX::Zero(system_->columns(C::kAngular));
        for (const int body : system_->moving_bodies()) {
            const std::size_t b = jw::at(body);
            const int column = system_->body_column(body, C::kAngular);
            const Vec4& p = instant_->state.p[b];
            const Vec3& omega_local = instant_->velocity.omega_local[b];
            if (order == 0) {
                all.segment<3>(column) = instant_->state.r[b];
                if constexpr (C::kNormalised) { all.segment<4>(column + 3) = p; }
            } else if (order == 1) {
                all.segment<3>(column) = instant_->velocity.r_dot[b];
                all.segment<C::kAngular>(column + 3) = angular_of<C>(p, omega_local);
            } else {
                const Vec3& omega_local_dot = instant_->acceleration->omega_local[b];
                all.segment<3>(column) = instant_->acceleration->r_dot[b];
                if constexpr (C::kNormalised) {
                    all.segment<4>(column + 3) = p_ddot_of_omega_local(p, omega_local, omega_local_dot);
                } else {
                    all.segment<3>(column + 3) = angular_of<C>(p, omega_local_dot);
                }
            }
        }
        for (const int theta : system_->active_thetas()) {
            const std::size_t k = jw::at(theta);
            const int column = system_->theta_column(theta, C::kAngular);
            all(column) = order == 0 ? instant_->state.theta[k]
                                     : (order == 1 ? instant_->velocity.theta_dot[k]
                                                   : instant_->acceleration->theta_dot[k]);
        }
        return all;
    }

    const MassProperties& mass_of(int body) const { return *instant_->scene->loads.masses[jw::at(body)]; }

    MatrixX mass_matrix() const {
        const int n = system_->columns(C::kAngular);
        MatrixX M = MatrixX::Zero(n, n);
        for (const int body : system_->moving_bodies()) {
            const int column = system_->body_column(body, C::kAngular);
            const MassProperties& mass = mass_of(body);
            M.block<3, 3>(column, column) = mass.mass * Mat3::Identity();
            const Vec4& p = instant_->state.p[jw::at(body)];
            if constexpr (C::kNormalised) {
                M.block<4, 4>(column + 3, column + 3) = 4.0 * L_of(p).transpose() * mass.J_local * L_of(p);
            } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
                const Mat3 A = rotation_matrix(p);
                M.block<3, 3>(column + 3, column + 3) = A * mass.J_local * A.transpose();
            } else {
                M.block<3, 3>(column + 3, column + 3) = mass.J_local;
            }
        }
        return M;
    }

    VectorX forces() const {
        VectorX Q = VectorX::Zero(system_->columns(C::kAngular));
        const std::vector<BodyForce> loads = forces_at(*instant_);
        for (const int body : system_->moving_bodies()) {
            const std::size_t b = jw::at(body);
            const int column = system_->body_column(body, C::kAngular);
            const Vec4& p = instant_->state.p[b];
            const Vec3 torque = loads[b].n_local +
                                gyroscopic_torque(mass_of(body).J_local, instant_->velocity.omega_local[b]);
            Q.segment<3>(column) = loads[b].f;
            if constexpr (C::kNormalised) {
                Q.segment<4>(column + 3) = 2.0 * L_of(p).transpose() * torque;
            } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
                Q.segment<3>(column + 3) = rotation_matrix(p) * torque;
            } else {
                Q.segment<3>(column + 3) = torque;
            }
        }
        return Q;
    }

    /// The multipliers of smallest norm that give the motion.
    VectorX multipliers() {
        const MatrixX transposed = assembler_.jacobian().transpose();
        const VectorX missing = mass_matrix() * columns(2) - forces();
        return transposed.completeOrthogonalDecomposition().solve(missing);
    }

    const Instant* instant_;
    const System* system_;
    Assembler<C> assembler_;
};

}  // namespace

std::optional<Value> value_of_system_symbol(
    const Instant& instant, CoordinateChoice coordinates, const Symbol& symbol) {
    return with_choice(
        coordinates, [&](auto choice) { return SystemAt<decltype(choice)>(instant).value(symbol); });
}

std::optional<Value> value_of_mass_symbol(const Instant& instant, int body, const Symbol& symbol) {
    const std::string name = name_of(symbol);
    if (!instant.scene || !instant.scene->loads.masses[jw::at(body)]) { return std::nullopt; }
    const MassProperties& mass = *instant.scene->loads.masses[jw::at(body)];
    const Mat3 A = rotation_matrix(instant.state.p[jw::at(body)]);
    if (name == "m") { return number(mass.mass); }
    if (name == "J′") { return constant(mass.J_local); }
    if (name == "J") {
        // d/dt (A J′ Aᵀ) = ω̃ J − J ω̃
        const Mat3 J = A * mass.J_local * A.transpose();
        const Mat3 turning = jw::tilde(A * instant.velocity.omega_local[jw::at(body)]);
        return moving(J, turning * J - J * turning, J, 1);
    }
    if (!has_centred_masses(instant)) { return std::nullopt; }
    const BodyForce force = forces_at(instant)[jw::at(body)];
    if (name == "f") { return still(force.f); }
    if (name == "n′") { return still(force.n_local); }
    if (name == "n") { return still(A * force.n_local); }
    return std::nullopt;
}

}  // namespace jw::formula
