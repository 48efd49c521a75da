#include "core/equations/assembler.hpp"

#include <algorithm>

#include "core/equations/inlined_visit.hpp"
#include "core/equations/measure_jet.hpp"
#include "core/jets/body_kinematics.hpp"

namespace jw {

namespace {

Theta theta_of(int theta, const State& state, const Motion* motion) {
    if (theta < 0) { return {}; }
    return {state.theta[at(theta)], motion != nullptr ? motion->theta_dot[at(theta)] : 0.0};
}

template <class C>
BodyKinematics<C> kinematics_of(int body, const State& state, const Motion& motion) {
    const std::size_t b = at(body);
    return kinematics_at<C>(state.r[b], state.p[b], motion.r_dot[b], motion.omega_local[b]);
}

}  // namespace

template <class C>
VectorX Layout<C>::columns_of(const State& state, const Motion& motion) const {
    VectorX columns = VectorX::Zero(this->columns());
    for (const int body : system_->moving_bodies()) {
        const int column = system_->body_column(body, C::kAngular);
        columns.segment<3>(column) = motion.r_dot[at(body)];
        columns.segment<C::kAngular>(column + 3) =
            angular_of<C>(state.p[at(body)], motion.omega_local[at(body)]);
    }
    for (const int theta : system_->active_thetas()) {
        columns(system_->theta_column(theta, C::kAngular)) = motion.theta_dot[at(theta)];
    }
    return columns;
}

template <class C>
Motion Layout<C>::motion_of(const State& state, const VectorX& columns) const {
    Motion motion = zero_motion(system_->mechanism());
    for (const int body : system_->moving_bodies()) {
        const int column = system_->body_column(body, C::kAngular);
        motion.r_dot[at(body)] = columns.segment<3>(column);
        motion.omega_local[at(body)] =
            omega_local_of_angular<C>(state.p[at(body)], columns.segment<C::kAngular>(column + 3));
    }
    for (const int theta : system_->active_thetas()) {
        motion.theta_dot[at(theta)] = columns(system_->theta_column(theta, C::kAngular));
    }
    return motion;
}

template <class C>
Motion Layout<C>::acceleration_of(const State& state, const VectorX& columns) const {
    // ω̇' = 2 L p̈ and ω̇ = A ω̇' have no extra terms (slide 13), so the map is the one for velocities
    return motion_of(state, columns);
}

template <class C>
void Layout<C>::advance(State& state, const VectorX& delta) const {
    for (const int body : system_->moving_bodies()) {
        const int column = system_->body_column(body, C::kAngular);
        const auto angular = delta.segment<C::kAngular>(column + 3);
        Vec4& p = state.p[at(body)];
        state.r[at(body)] += delta.segment<3>(column);
        if constexpr (C::kNormalised) {
            p += angular;
        } else if constexpr (C::kChoice == CoordinateChoice::omega_global) {
            p = turned_global(p, angular);
        } else {
            p = turned_local(p, angular);
        }
    }
    for (const int theta : system_->active_thetas()) {
        state.theta[at(theta)] += delta(system_->theta_column(theta, C::kAngular));
    }
}

template <class C>
double Layout<C>::largest_turn(const VectorX& delta) const {
    // |Δφ| = 2 |Δp| for a unit p
    constexpr double turn_per_unit = C::kNormalised ? 2.0 : 1.0;
    double largest = 0.0;
    for (const int body : system_->moving_bodies()) {
        const int column = system_->body_column(body, C::kAngular);
        largest = std::max(largest, turn_per_unit * delta.segment<C::kAngular>(column + 3).norm());
    }
    return largest;
}

template <class C>
Assembler<C>::Assembler(const System& system, bool normalisation_rows)
    : system_(&system),
      layout_(system),
      normalisation_rows_(C::kNormalised && normalisation_rows),
      bodies_(system.mechanism().bodies.size()),
      phi_(VectorX::Zero(system.rows(normalisation_rows_))),
      sparse_{layout_.columns(), kColumnsPerBody<C>, std::vector<SparseRow>(at(phi_.size()))},
      nu_(VectorX::Zero(phi_.size())),
      gamma_(VectorX::Zero(phi_.size())) {}

template <class C>
template <Content K>
void Assembler<C>::set_bodies(const State& state, const Motion* motion) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        BodyKinematics<C>& body = bodies_[b];
        body.r = state.r[b];
        body.p = state.p[b];
        body.A = C::rotation(body.p);
        body.G = G_of(body.p);
        if constexpr (K == Content::motion) {
            body.r_dot = motion->r_dot[b];
            C::set_motion(body, motion->omega_local[b]);
        }
    }
}

template <class C>
template <class J>
void Assembler<C>::write_rows(
    const J& jet, int body_i, int body_j, int theta, unsigned left_out, int first_row) {
    constexpr int width = kColumnsPerBody<C>;
    const int column_i = system_->body_column(body_i, C::kAngular);
    const int column_j = system_->body_column(body_j, C::kAngular);
    const auto copy = [](const auto& from, auto& to) {
        for (int k = 0; k < width; ++k) { to[at(k)] = from(k); }
    };
    int row = first_row;
    for (int component = 0; component < J::kDim; ++component) {
        if (((left_out >> component) & 1U) != 0) { continue; }
        phi_(row) = jet.value(component);
        SparseRow& entries = row_at(row);
        entries = SparseRow{};
        if constexpr ((J::kSides & kBodyI) != 0) {
            entries.first_column[0] = column_i;
            copy(jet.block_i.row(component), entries.block[0]);
        }
        if constexpr ((J::kSides & kBodyJ) != 0) {
            entries.first_column[1] = column_j;
            copy(jet.block_j.row(component), entries.block[1]);
        }
        if constexpr ((J::kSides & kTheta) != 0) {
            entries.theta_column = system_->theta_column(theta, C::kAngular);
            entries.theta = jet.block_theta(component);
        }
        ++row;
    }
}

template <class C>
const MatrixX& Assembler<C>::jacobian() const {
    if (jacobian_is_old_) {
        jacobian_.resize(phi_.size(), layout_.columns());
        sparse_.write(jacobian_);
        jacobian_is_old_ = false;
    }
    return jacobian_;
}

template <class C>
void Assembler<C>::assemble_phi_and_jacobian(const State& state, double t) {
    set_bodies<Content::jacobian>(state, nullptr);
    jacobian_is_old_ = true;
    const auto body = [&](int b) -> const BodyKinematics<C>& { return bodies_[at(b)]; };

    for (const Constraint& c : system_->constraints()) {
        visit_inlined(
            [&](const auto& primitive) {
                const auto jet = equations<Content::jacobian>(
                    primitive, body(c.body_i), body(c.body_j), theta_of(c.theta, state, nullptr));
                write_rows(jet, c.body_i, c.body_j, c.theta, c.left_out(), c.first_row);
            },
            c.primitive);
    }
    for (const DriverConstraint& c : system_->drivers()) {
        const Driver& d = system_->mechanism().drivers[at(c.driver)];
        std::visit(
            [&](const auto& measure) {
                auto jet = measured<Content::jacobian>(
                    measure, body(d.body_i), body(d.body_j), theta_of(c.theta, state, nullptr));
                jet.value(0) =
                    driver_residual(d.measure, jet.value(0), target_of(d.measure, d.function, t).f);
                write_rows(jet, d.body_i, d.body_j, c.theta, 0U, c.row);
            },
            d.measure);
    }
    if constexpr (C::kNormalised) {
        if (!normalisation_rows_) { return; }
        int row = system_->rows();
        for (const int b : system_->moving_bodies()) {
            phi_(row) = body(b).p.squaredNorm() - 1.0;
            SparseRow& entries = row_at(row);
            entries = SparseRow{};
            entries.first_column[0] = system_->body_column(b, 4);
            for (int k = 0; k < 4; ++k) { entries.block[0][at(k + 3)] = 2.0 * body(b).p(k); }
            ++row;
        }
    }
}

template <class C>
void Assembler<C>::assemble_nu(double t) {
    nu_.setZero();
    for (const DriverConstraint& c : system_->drivers()) {
        const Driver& d = system_->mechanism().drivers[at(c.driver)];
        nu_(c.row) = target_of(d.measure, d.function, t).f_dot;
    }
}

template <class C>
void Assembler<C>::assemble_gamma(const State& state, const Motion& motion, double t) {
    set_bodies<Content::motion>(state, &motion);
    const auto body = [&](int b) -> const BodyKinematics<C>& { return bodies_[at(b)]; };

    for (const Constraint& c : system_->constraints()) {
        visit_inlined(
            [&](const auto& primitive) {
                const auto jet = equations<Content::motion>(
                    primitive, body(c.body_i), body(c.body_j), theta_of(c.theta, state, &motion));
                int row = c.first_row;
                for (int component = 0; component < jet.kDim; ++component) {
                    if (c.has_row(component)) { gamma_(row++) = -jet.bias(component); }
                }
            },
            c.primitive);
    }
    for (const DriverConstraint& c : system_->drivers()) {
        const Driver& d = system_->mechanism().drivers[at(c.driver)];
        std::visit(
            [&](const auto& measure) {
                const auto jet = measured<Content::motion>(
                    measure, body(d.body_i), body(d.body_j), theta_of(c.theta, state, &motion));
                gamma_(c.row) = target_of(d.measure, d.function, t).f_ddot - jet.bias(0);
            },
            d.measure);
    }
    if constexpr (C::kNormalised) {
        if (!normalisation_rows_) { return; }
        int row = system_->rows();
        for (const int b : system_->moving_bodies()) { gamma_(row++) = -2.0 * body(b).p_dot.squaredNorm(); }
    }
}

template class Layout<TrueEulerParameters>;
template class Layout<ModifiedEulerParameters>;
template class Layout<OmegaLocal>;
template class Layout<OmegaGlobal>;
template class Assembler<TrueEulerParameters>;
template class Assembler<ModifiedEulerParameters>;
template class Assembler<OmegaLocal>;
template class Assembler<OmegaGlobal>;

template <class C>
ConstraintTerms terms_of(const Constraint& constraint, const State& state, const Motion& motion) {
    const BodyKinematics<C> i = kinematics_of<C>(constraint.body_i, state, motion);
    const BodyKinematics<C> j = kinematics_of<C>(constraint.body_j, state, motion);
    const Theta theta = theta_of(constraint.theta, state, &motion);
    const auto visit = [&](const auto& primitive) {
        const auto moving = equations<Content::motion>(primitive, i, j, theta);
        const auto jet = equations<Content::jacobian>(primitive, i, j, theta);
        using J = std::decay_t<decltype(jet)>;
        const MatrixX none = MatrixX::Zero(J::kDim, kColumnsPerBody<C>);
        ConstraintTerms terms{moving.value, moving.rate, moving.bias, none, none, VectorX::Zero(J::kDim)};
        if constexpr ((J::kSides & kBodyI) != 0) { terms.block_i = jet.block_i; }
        if constexpr ((J::kSides & kBodyJ) != 0) { terms.block_j = jet.block_j; }
        if constexpr ((J::kSides & kTheta) != 0) { terms.block_theta = jet.block_theta; }
        return terms;
    };
    return std::visit(visit, constraint.primitive);
}

template ConstraintTerms terms_of<TrueEulerParameters>(const Constraint&, const State&, const Motion&);
template ConstraintTerms terms_of<ModifiedEulerParameters>(const Constraint&, const State&, const Motion&);
template ConstraintTerms terms_of<OmegaLocal>(const Constraint&, const State&, const Motion&);
template ConstraintTerms terms_of<OmegaGlobal>(const Constraint&, const State&, const Motion&);

VectorX values_of(const Constraint& constraint, const State& state) {
    const auto kinematics = [&](int b) { return kinematics_at<OmegaLocal>(state.r[at(b)], state.p[at(b)]); };
    const auto i = kinematics(constraint.body_i);
    const auto j = kinematics(constraint.body_j);
    return std::visit(
        [&](const auto& primitive) -> VectorX {
            return equations<Content::jacobian>(primitive, i, j, theta_of(constraint.theta, state, nullptr))
                .value;
        },
        constraint.primitive);
}

Measured evaluate_measure(
    const Measure& measure, int body_i, int body_j, int theta, const State& state, const Motion& velocity,
    const Motion& acceleration) {
    const MeasureJet jet = jet_of(
        measure, kinematics_of<OmegaLocal>(body_i, state, velocity),
        kinematics_of<OmegaLocal>(body_j, state, velocity), theta_of(theta, state, &velocity));
    const auto accelerations = [&](int b) {
        Eigen::Matrix<double, 6, 1> columns;
        columns << acceleration.r_dot[at(b)], acceleration.omega_local[at(b)];
        return columns;
    };
    const double linear = jet.by_i.dot(accelerations(body_i)) + jet.by_j.dot(accelerations(body_j)) +
                          (theta >= 0 ? jet.by_theta * acceleration.theta_dot[at(theta)] : 0.0);
    return {jet.value, jet.rate, linear + jet.bias};
}

}  // namespace jw
