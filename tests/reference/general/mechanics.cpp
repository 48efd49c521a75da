#include "tests/reference/general/mechanics.hpp"

#include <numeric>

namespace jw::reference::general {

namespace {

Real friction(const Friction& f, Real rate) { return f.size * rate / std::hypot(rate, f.speed); }
Real law(const std::optional<FormulaTree>& f, Real value, Real rate) {
    return f ? value_of(*f, {{value}, {rate}}).value : 0.0L;
}

constexpr Eigen::Index kPerBody = 13;
// pivots of unit rows: redundant ones leave rounding of the double numbers of a lesson, 1e-15; scenes that
// are near-singular on purpose stay above 1e-7
constexpr Real kRepeats = 1e-10L;

Vec4 turned(const Vec4& p, const Vec3& turn) {
    const Vec3 half = 0.5L * turn;
    return product(Vec4(1.0L, half.x(), half.y(), half.z()), p).normalized();
}

}  // namespace

Mechanics::Mechanics(const Model& model) : model_(model) {
    place_.assign(model_.bodies.size(), -1);
    bodies_.resize(model_.bodies.size());
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
        const Body& body = model_.bodies[b];
        cholesky_.push_back(body.fixed ? Mat3::Identity() : Mat3(body.J.llt().matrixL()));
        Placed& placed = bodies_[b];
        placed.centre = body.fixed ? Vec3::Zero() : body.centre;
        placed.p = body.p.normalized();
        placed.A = rotation(placed.p);
        placed.c = body.r + placed.A * placed.centre;
        if (body.fixed) { continue; }
        placed.omega = body.omega;
        placed.v = body.v + body.omega.cross(placed.A * placed.centre);
        place_[b] = static_cast<int>(moving_.size());
        moving_.push_back(static_cast<int>(b));
    }
    all_.resize(model_.equations.size());
    std::iota(all_.begin(), all_.end(), 0);
    for (const TurningSpring& spring : model_.turning_springs) {
        const Real angle = angle_value(spring.angle, bodies_).value - spring.free_angle;
        twists_.push_back(std::remainder(angle, 2.0L * kPi));
    }
}

VecX Mechanics::state_of(const PlacedBodies& bodies, Real t) const {
    VecX y(kPerBody * static_cast<Eigen::Index>(moving_.size()) + 1);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Placed& body = bodies[static_cast<std::size_t>(moving_[m])];
        y.segment<kPerBody>(kPerBody * static_cast<Eigen::Index>(m)) << body.c, body.p, body.v, body.omega;
    }
    y[y.size() - 1] = t;
    return y;
}

VecX Mechanics::start() const { return state_of(bodies_, 0.0L); }

void Mechanics::set_state(const VecX& y) {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto numbers = y.segment<kPerBody>(kPerBody * static_cast<Eigen::Index>(m));
        Placed& body = bodies_[static_cast<std::size_t>(moving_[m])];
        body.c = numbers.segment<3>(0);
        body.p = numbers.segment<4>(3);
        body.v = numbers.segment<3>(7);
        body.omega = numbers.segment<3>(10);
        body.A = rotation(body.p);
    }
    t_ = y[y.size() - 1];
}

const PlacedBodies& Mechanics::bodies_at(const VecX& y) {
    set_state(y);
    return bodies_;
}

void Mechanics::find_rows(const std::vector<int>& which) {
    const auto count = static_cast<Eigen::Index>(which.size());
    rows_ = MatX::Zero(count, unknowns());
    scale_.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Equation& equation =
            model_.equations[static_cast<std::size_t>(which[static_cast<std::size_t>(k)])];
        for (const Pull& pull : gradient_of(equation, bodies_)) {
            const auto b = static_cast<std::size_t>(pull.body);
            if (place_[b] < 0) { continue; }
            const Eigen::Index column = 6 * place_[b];
            rows_.block<1, 3>(k, column) += pull.force.transpose() / std::sqrt(model_.bodies[b].mass);
            const Vec3 local = bodies_[b].A.transpose() * pull.torque;
            const Vec3 weighted = cholesky_[b].triangularView<Eigen::Lower>().solve(local);
            rows_.block<1, 3>(k, column + 3) += weighted.transpose();
        }
        scale_[k] = rows_.row(k).norm();
        if (scale_[k] > 0.0L) { rows_.row(k) /= scale_[k]; }
    }
}

Rows Mechanics::rows_at(const VecX& y) {
    set_state(y);
    find_rows(all_);
    Rows out{rows_, scale_, {}, 1.0L, 0.0L};
    if (rows_.rows() == 0 || rows_.cols() == 0) { return out; }
    const Eigen::ColPivHouseholderQR<MatX> qr(rows_.transpose());
    const auto pivots = qr.matrixQR().diagonal().cwiseAbs().eval();
    const auto& order = qr.colsPermutation().indices();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) {
        if (!(pivots[k] > kRepeats)) {
            out.gap = pivots[k];
            break;
        }
        out.kept.push_back(order[k]);
        out.condition = pivots[0] / pivots[k];
    }
    return out;
}

int Mechanics::rank_at(const VecX& y) { return static_cast<int>(rows_at(y).kept.size()); }

void Mechanics::begin_step(const VecX& y) {
    kept_ = rows_at(y).kept;
    for (std::size_t k = 0; k < twists_.size(); ++k) {
        const TurningSpring& spring = model_.turning_springs[k];
        const Real angle = angle_value(spring.angle, bodies_).value - spring.free_angle;
        twists_[k] += std::remainder(angle - twists_[k], 2.0L * kPi);
    }
}

VecX Mechanics::values(const std::vector<int>& which, Real Taylor::*part) const {
    VecX out(static_cast<Eigen::Index>(which.size()));
    for (Eigen::Index k = 0; k < out.size(); ++k) {
        const auto equation = static_cast<std::size_t>(which[static_cast<std::size_t>(k)]);
        const Real value = phi_of(model_.equations[equation], bodies_, t_).*part;
        out[k] = scale_[k] > 0.0L ? value / scale_[k] : value;
    }
    return out;
}

VecX Mechanics::least(const VecX& image) const {
    if (rows_.rows() == 0) { return VecX::Zero(unknowns()); }
    // rows = Rᵀ Qᵀ, z = Q R⁻ᵀ image
    const Eigen::HouseholderQR<MatX> qr(rows_.transpose());
    const Eigen::Index n = rows_.rows();
    VecX z = VecX::Zero(unknowns());
    z.head(n) = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>().transpose().solve(image);
    z.applyOnTheLeft(qr.householderQ());
    return z;
}

VecX Mechanics::velocities() const {
    VecX z(unknowns());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto b = static_cast<std::size_t>(moving_[m]);
        const auto k = static_cast<Eigen::Index>(6 * m);
        z.segment<3>(k) = std::sqrt(model_.bodies[b].mass) * bodies_[b].v;
        z.segment<3>(k + 3) = cholesky_[b].transpose() * (bodies_[b].A.transpose() * bodies_[b].omega);
    }
    return z;
}

/// Moves bodies by S⁻ᵀ z.
void Mechanics::displace(VecX& y, const VecX& z) const {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto b = static_cast<std::size_t>(moving_[m]);
        const auto k = static_cast<Eigen::Index>(6 * m);
        const auto place = kPerBody * static_cast<Eigen::Index>(m);
        y.segment<3>(place) += z.segment<3>(k) / std::sqrt(model_.bodies[b].mass);
        const Vec3 local = cholesky_[b].transpose().triangularView<Eigen::Upper>().solve(z.segment<3>(k + 3));
        y.segment<4>(place + 3) = turned(y.segment<4>(place + 3), bodies_[b].A * local);
    }
}

/// Adds S⁻ᵀ z to the velocities in y, or to the accelerations where y is a rate.
void Mechanics::accelerate(VecX& y, const VecX& z) const {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto b = static_cast<std::size_t>(moving_[m]);
        const auto k = static_cast<Eigen::Index>(6 * m);
        const auto place = kPerBody * static_cast<Eigen::Index>(m);
        y.segment<3>(place + 7) += z.segment<3>(k) / std::sqrt(model_.bodies[b].mass);
        const Vec3 local = cholesky_[b].transpose().triangularView<Eigen::Upper>().solve(z.segment<3>(k + 3));
        y.segment<3>(place + 10) += bodies_[b].A * local;
    }
}

void Mechanics::push(std::vector<Loaded>& loads, const Fixed& point, const Vec3& force) const {
    const auto b = static_cast<std::size_t>(point.body);
    loads[b].force += force;
    loads[b].torque += (bodies_[b].A * (point.local - bodies_[b].centre)).cross(force);
}

std::vector<Mechanics::Loaded> Mechanics::loads() const {
    std::vector<Loaded> out(bodies_.size());
    for (const int b : moving_) {
        const auto body = static_cast<std::size_t>(b);
        out[body].force += model_.bodies[body].mass * model_.gravity;
    }
    const auto turned_by = [&](int body, bool local, const Vec3& v) -> Vec3 {
        return local ? Vec3(bodies_[static_cast<std::size_t>(body)].A * v) : v;
    };
    for (const Force& f : model_.forces) {
        const Real size = time_function(f.magnitude, t_).value;
        push(out, f.point, turned_by(f.point.body, f.local, size * f.direction));
    }
    for (const Torque& n : model_.torques) {
        const Real size = time_function(n.magnitude, t_).value;
        const Vec3 torque = turned_by(n.body, n.local, size * n.direction);
        out[static_cast<std::size_t>(n.body)].torque += torque;
        if (n.against >= 0) { out[static_cast<std::size_t>(n.against)].torque -= torque; }
    }
    for (const Spring& s : model_.springs) {
        const TaylorVector d = point_of(bodies_, s.j) - point_of(bodies_, s.i);
        if (s.axis) {
            // the gradient of s · d: ±s at the points, s x d by the turn of the axis
            const TaylorVector axis = direction_of(bodies_, *s.axis);
            const Taylor way = dot(axis, d);
            const Real pull = s.stiffness * (way.value - s.free_length) + s.damping * way.rate +
                              friction(s.friction, way.rate) + law(s.law, way.value, way.rate);
            push(out, s.i, pull * axis.value);
            push(out, s.j, -pull * axis.value);
            out[static_cast<std::size_t>(s.axis->body)].torque -= pull * axis.value.cross(d.value);
            continue;
        }
        const Real length = d.value.norm();
        const Vec3 along = length > 0.0L ? Vec3(d.value / length) : Vec3(Vec3::Zero());
        const Real rate = along.dot(d.rate);
        const Real pull = s.stiffness * (length - s.free_length) + s.damping * rate +
                          friction(s.friction, rate) + law(s.law, length, rate);
        push(out, s.i, pull * along);
        push(out, s.j, -pull * along);
    }
    for (std::size_t k = 0; k < model_.turning_springs.size(); ++k) {
        const TurningSpring& s = model_.turning_springs[k];
        const Taylor angle = angle_value(s.angle, bodies_);
        const Real twist = twists_[k] + std::remainder(angle.value - s.free_angle - twists_[k], 2.0L * kPi);
        const Vec3 axis = direction_of(bodies_, s.angle.s).value;
        const Vec3 torque =
            -(s.stiffness * twist + s.damping * angle.rate + friction(s.friction, angle.rate) +
              law(s.law, twist + s.free_angle, angle.rate)) *
            axis;
        out[static_cast<std::size_t>(s.angle.u_j.body)].torque += torque;
        out[static_cast<std::size_t>(s.angle.u_i.body)].torque -= torque;
    }
    return out;
}

/// Sᵀ M⁻¹ Q.
VecX Mechanics::free_accelerations() const {
    const std::vector<Loaded> pushed = loads();
    VecX z(unknowns());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto b = static_cast<std::size_t>(moving_[m]);
        const auto k = static_cast<Eigen::Index>(6 * m);
        const Mat3& A = bodies_[b].A;
        const Vec3 local = A.transpose() * bodies_[b].omega;
        const Vec3 torque = A.transpose() * pushed[b].torque - local.cross(model_.bodies[b].J * local);
        z.segment<3>(k) = pushed[b].force / std::sqrt(model_.bodies[b].mass);
        z.segment<3>(k + 3) = cholesky_[b].triangularView<Eigen::Lower>().solve(torque);
    }
    return z;
}

void Mechanics::derivative(const VecX& y, VecX& y_dot) {
    set_state(y);
    find_rows(kept_);
    VecX z = free_accelerations();
    z += least(-values(kept_, &Taylor::second) - rows_ * z);
    y_dot = VecX::Zero(y.size());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Placed& body = bodies_[static_cast<std::size_t>(moving_[m])];
        const auto place = kPerBody * static_cast<Eigen::Index>(m);
        y_dot.segment<3>(place) = body.v;
        const Vec3& w = body.omega;
        y_dot.segment<4>(place + 3) = 0.5L * product(Vec4(0.0L, w.x(), w.y(), w.z()), body.p);
    }
    accelerate(y_dot, z);
    y_dot[y.size() - 1] = 1.0L;
}

void Mechanics::project(VecX& y) {
    // Newton doubles the digits: the errors of steps and of doubles, 1e-16, are gone after one or two
    constexpr int most = 12;
    for (int iteration = 0; iteration < most; ++iteration) {
        set_state(y);
        find_rows(kept_);
        const VecX off = values(kept_, &Taylor::value);
        if (off.size() == 0 || off.lpNorm<Eigen::Infinity>() < 1e-18L) { break; }
        displace(y, least(-off));
        if (off.lpNorm<Eigen::Infinity>() < 1e-10L) { break; }
    }
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        y.segment<4>(kPerBody * static_cast<Eigen::Index>(m) + 3).normalize();
    }
    set_state(y);
    find_rows(kept_);
    accelerate(y, least(-values(kept_, &Taylor::rate)));
}

Real Mechanics::project_velocities(VecX& y) {
    kept_ = rows_at(y).kept;
    find_rows(kept_);
    accelerate(y, least(-values(kept_, &Taylor::rate)));
    return violation_at(y).second;
}

std::pair<Real, Real> Mechanics::violation_at(const VecX& y) {
    set_state(y);
    find_rows(all_);
    if (all_.empty()) { return {0.0L, 0.0L}; }
    return {
        values(all_, &Taylor::value).lpNorm<Eigen::Infinity>(),
        values(all_, &Taylor::rate).lpNorm<Eigen::Infinity>()};
}

Accelerations Mechanics::accelerations_at(const VecX& y) {
    const Rows all = rows_at(y);
    kept_ = all.kept;
    VecX y_dot;
    derivative(y, y_dot);
    Accelerations out;
    out.rank = static_cast<int>(all.kept.size());
    out.condition = all.condition;
    out.v_dot.assign(bodies_.size(), Vec3::Zero());
    out.omega_dot.assign(bodies_.size(), Vec3::Zero());
    out.free_v_dot = out.v_dot;
    out.free_omega_dot = out.omega_dot;
    VecX unconstrained = VecX::Zero(y.size());
    accelerate(unconstrained, free_accelerations());
    VecX z = VecX::Zero(unknowns());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const auto b = static_cast<std::size_t>(moving_[m]);
        const auto place = kPerBody * static_cast<Eigen::Index>(m);
        out.free_v_dot[b] = unconstrained.segment<3>(place + 7);
        out.free_omega_dot[b] = unconstrained.segment<3>(place + 10);
        out.v_dot[b] = y_dot.segment<3>(place + 7);
        out.omega_dot[b] = y_dot.segment<3>(place + 10);
        const auto k = static_cast<Eigen::Index>(6 * m);
        z.segment<3>(k) = std::sqrt(model_.bodies[b].mass) * out.v_dot[b];
        z.segment<3>(k + 3) = cholesky_[b].transpose() * (bodies_[b].A.transpose() * out.omega_dot[b]);
    }
    find_rows(all_);
    if (!all_.empty()) {
        const VecX second = values(all_, &Taylor::second);
        const VecX off = all.rows * z + second;
        // where nothing moves, rounding is not a contradiction
        const Real least = z.norm() + 1e-9L;
        for (Eigen::Index k = 0; k < off.size(); ++k) {
            const Real size = all.rows.row(k).norm() * least + std::abs(second(k));
            const Real here = std::abs(off(k)) / size;
            // NaN counts as a contradiction
            if (!(here <= out.contradiction)) { out.contradiction = here; }
        }
    }
    return out;
}

Real Mechanics::kinetic_energy(const VecX& y) {
    set_state(y);
    return 0.5L * velocities().squaredNorm();
}

std::pair<Vec3, Vec3> Mechanics::momentum(const VecX& y) {
    set_state(y);
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    for (const int m : moving_) {
        const auto b = static_cast<std::size_t>(m);
        const Placed& body = bodies_[b];
        const Vec3 p = model_.bodies[b].mass * body.v;
        linear += p;
        angular += body.c.cross(p) + body.A * (model_.bodies[b].J * (body.A.transpose() * body.omega));
    }
    return {linear, angular};
}

Sample Mechanics::sample(const VecX& y) {
    set_state(y);
    if (moving_.empty()) { return {}; }
    const Placed& body = bodies_[static_cast<std::size_t>(moving_.back())];
    return {body.c, body.v};
}

}  // namespace jw::reference::general
