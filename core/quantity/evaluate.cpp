#include "core/quantity/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "core/equations/assembler.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/quantity/residuals.hpp"

namespace jw {

namespace {

// relative to the forces: far above rounding, 1e-13; a pose that was pulled to another place has a larger
// residual
constexpr double kNoMotion = 1e-6;

QuantityValue absent(Absence why) {
    QuantityValue out;
    out.absences.fill(why);
    return out;
}

/// A vector with its first two derivatives, as far as they are known.
struct MovingVector {
    Vec3 value = Vec3::Zero();
    Vec3 rate = Vec3::Zero();
    Vec3 acceleration = Vec3::Zero();
};

/// A distance from its square: with D = d², Ḋ = 2 d ḋ and D̈ = 2 ḋ² + 2 d d̈.
Measured distance_of(const Measured& squared) {
    const double d = std::sqrt(squared.value);
    const double rate = squared.rate / (2.0 * d);
    return {d, rate, (0.5 * squared.acceleration - rate * rate) / d};
}

/// Rates of the energies [W]: kinetic energy from the accelerations; potential energy as the power that
/// gravity and springs absorb.
Energy energy_rate_of(
    const Centroidal& scene, const State& state, const Motion& motion, const Motion& acceleration) {
    Loads conservative = scene.loads;
    conservative.forces.clear();
    conservative.torques.clear();
    const auto leave_out = [](auto& spring) {
        if (depends_on_time(spring)) { spring.law.reset(); }
    };
    std::ranges::for_each(conservative.springs, leave_out);
    std::ranges::for_each(conservative.rotational_springs, leave_out);
    // these bodies are at rest, so dampers have no force, and laws give their force at rest
    const auto bodies = kinematics_of(state);
    std::vector<BodyForce> forces(bodies.size());
    add_forces(conservative, bodies, 0.0, forces);
    Energy rate;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Vec3& omega_local = motion.omega_local[b];
        rate.potential -= forces[b].f.dot(motion.r_dot[b]) + forces[b].n_local.dot(omega_local);
        const auto& own = scene.loads.masses[b];
        if (!own) { continue; }
        rate.kinetic += own->mass * motion.r_dot[b].dot(acceleration.r_dot[b]) +
                        omega_local.dot(own->J_local * acceleration.omega_local[b]);
    }
    return rate;
}

class Evaluation {
public:
    Evaluation(const Instant& instant, int highest) : instant_(&instant), highest_(highest) {}

    QuantityValue operator()(const MeasureQuantity& q) const;
    QuantityValue operator()(const AngularVelocityQuantity& q) const;
    QuantityValue operator()(const PointQuantity& q) const;
    QuantityValue operator()(const PointSpeedQuantity& q) const;
    QuantityValue operator()(const BodySizeQuantity& q) const;
    QuantityValue operator()(const DirectionsQuantity& q) const;
    QuantityValue operator()(const EnergyQuantity& q) const;
    QuantityValue operator()(const ReactionQuantity& q) const;
    QuantityValue operator()(const EffortQuantity& q) const;
    QuantityValue operator()(const ParameterErrorQuantity& q) const;
    QuantityValue operator()(const ResidualQuantity& q) const { return residual_at(q, *instant_, highest_); }
    QuantityValue operator()(const SingularValueQuantity& q) const;
    QuantityValue operator()(const PairConditionQuantity& q) const;

private:
    /// Value and derivatives `numbers`. Those from `first_of_accelerations` on need accelerations; they are
    /// left out if these are not known.
    QuantityValue with_accelerations(std::array<double, 3> numbers, int first_of_accelerations) const;
    Mat3 A(int body) const { return rotation_matrix(instant_->state.p[at(body)]); }
    /// Acceleration of the origin; zero if it is not known: the caller omits the values that depend on it.
    Vec3 r_ddot(int body) const {
        return instant_->acceleration ? instant_->acceleration->r_dot[at(body)] : Vec3::Zero();
    }
    Vec3 omega_local_dot(int body) const {
        return instant_->acceleration ? instant_->acceleration->omega_local[at(body)] : Vec3::Zero();
    }
    MovingVector arm(int body, const Vec3& s_local) const;
    MovingVector point(int body, const Vec3& s_local) const;
    /// Size of the vector and its rate; the second derivative if `twice`.
    QuantityValue size_of(const MovingVector& v, int first_of_accelerations, bool twice) const;
    const Reaction* reaction_of(int joint, int driver, Absence& why) const;

    const Instant* instant_;
    int highest_;
};

QuantityValue Evaluation::with_accelerations(
    std::array<double, 3> numbers, int first_of_accelerations) const {
    QuantityValue out;
    for (int k = 0; k < 3; ++k) {
        const bool known = k < first_of_accelerations || instant_->acceleration.has_value();
        if (known) { out.derivatives[at(k)] = numbers[at(k)]; }
        const bool is_number = known && !std::isnan(numbers[at(k)]);
        out.absences[at(k)] = is_number ? Absence::none
                              : known   ? Absence::no_derivative
                                        : Absence::no_acceleration;
    }
    return out;
}

QuantityValue Evaluation::operator()(const MeasureQuantity& q) const {
    const State& state = instant_->state;
    if (const auto* c = std::get_if<CoordinateMeasure>(&q.measure); c != nullptr && c->coordinate < 3) {
        const int k = c->coordinate;
        return with_accelerations(
            {state.r[at(q.body_j)](k), instant_->velocity.r_dot[at(q.body_j)](k), r_ddot(q.body_j)(k)}, 2);
    }
    if (const auto* c = std::get_if<CoordinateMeasure>(&q.measure); c != nullptr && highest_ == 0) {
        return with_accelerations(
            {state.p[at(q.body_j)](c->coordinate - 3), QuantityValue::kNone, QuantityValue::kNone}, 1);
    }
    const Mechanism& mechanism = instant_->system->mechanism();
    const int theta = q.joint < 0 ? -1 : mechanism.theta_indices()[at(q.joint)];
    Motion none;
    if (!instant_->acceleration) { none = zero_motion(mechanism); }
    Measured m = evaluate_measure(
        q.measure, q.body_i, q.body_j, std::holds_alternative<ThetaMeasure>(q.measure) ? theta : -1, state,
        instant_->velocity, instant_->acceleration ? *instant_->acceleration : none);
    if (std::holds_alternative<SquaredDistanceMeasure>(q.measure)) {
        if (m.value == 0.0) {
            QuantityValue out = absent(Absence::singular);
            out.derivatives[0] = 0.0;
            out.absences[0] = Absence::none;
            return out;
        }
        m = distance_of(m);
    }
    if (std::holds_alternative<AngleMeasure>(q.measure) && q.joint >= 0 && !instant_->turns.empty()) {
        m.value += 2.0 * std::numbers::pi * instant_->turns[at(q.joint)];
    }
    return with_accelerations({m.value, m.rate, m.acceleration}, 2);
}

QuantityValue Evaluation::operator()(const AngularVelocityQuantity& q) const {
    const Vec3& omega_local = instant_->velocity.omega_local[at(q.body)];
    const auto turned = [&](const Vec3& local) {
        // ω̇ = A ω̇': no extra term
        return (q.local ? local : Vec3(A(q.body) * local))(q.component);
    };
    return with_accelerations(
        {turned(omega_local), turned(omega_local_dot(q.body)), QuantityValue::kNone}, 1);
}

MovingVector Evaluation::arm(int body, const Vec3& s_local) const {
    const Mat3 R = A(body);
    const Vec3 s = R * s_local;
    const Vec3 omega = R * instant_->velocity.omega_local[at(body)];
    const Vec3 omega_dot = R * omega_local_dot(body);
    return {s, omega.cross(s), omega_dot.cross(s) + omega.cross(omega.cross(s))};
}

MovingVector Evaluation::point(int body, const Vec3& s_local) const {
    const Mat3 R = A(body);
    const Vec3 s = R * s_local;
    const Vec3 omega = R * instant_->velocity.omega_local[at(body)];
    const Vec3 omega_dot = R * omega_local_dot(body);
    return {
        instant_->state.r[at(body)] + s, instant_->velocity.r_dot[at(body)] + omega.cross(s),
        r_ddot(body) + omega_dot.cross(s) + omega.cross(omega.cross(s))};
}

QuantityValue Evaluation::operator()(const PointQuantity& q) const {
    const MovingVector p = point(q.body, q.s_local);
    return with_accelerations({p.value(q.component), p.rate(q.component), p.acceleration(q.component)}, 2);
}

QuantityValue Evaluation::size_of(const MovingVector& v, int first_of_accelerations, bool twice) const {
    const double size = v.value.norm();
    const double rate = v.value.dot(v.rate) / size;
    const double acceleration = (v.rate.squaredNorm() + v.value.dot(v.acceleration) - rate * rate) / size;
    QuantityValue out =
        with_accelerations({size, rate, twice ? acceleration : QuantityValue::kNone}, first_of_accelerations);
    if (size > 0.0) { return out; }
    for (int k = 1; k < 3; ++k) {
        if (out.absences[at(k)] == Absence::no_derivative) { out.absences[at(k)] = Absence::singular; }
    }
    return out;
}

QuantityValue Evaluation::operator()(const PointSpeedQuantity& q) const {
    const MovingVector p = point(q.body, q.s_local);
    return size_of({p.rate, p.acceleration, Vec3::Zero()}, 1, false);
}

QuantityValue Evaluation::operator()(const BodySizeQuantity& q) const {
    const Vec3& r_dot = instant_->velocity.r_dot[at(q.body)];
    const Mat3 R = A(q.body);
    const Vec3 omega = R * instant_->velocity.omega_local[at(q.body)];
    const Vec3 omega_dot = R * omega_local_dot(q.body);
    constexpr double none = QuantityValue::kNone;
    switch (q.vector) {
        case BodyVector::r: return size_of({instant_->state.r[at(q.body)], r_dot, r_ddot(q.body)}, 2, true);
        case BodyVector::r_dot: return size_of({r_dot, r_ddot(q.body), Vec3::Zero()}, 1, false);
        case BodyVector::r_ddot: return with_accelerations({r_ddot(q.body).norm(), none, none}, 0);
        case BodyVector::omega: return size_of({omega, omega_dot, Vec3::Zero()}, 1, false);
        case BodyVector::omega_dot: break;
    }
    return with_accelerations({omega_dot.norm(), none, none}, 0);
}

QuantityValue Evaluation::operator()(const DirectionsQuantity& q) const {
    const MovingVector a = arm(q.body_i, q.a_i_local.normalized());
    const MovingVector b = arm(q.body_j, q.a_j_local.normalized());
    const double sine = a.value.cross(b.value).norm();
    const double cosine = a.value.dot(b.value);
    const double cosine_dot = a.rate.dot(b.value) + a.value.dot(b.rate);
    const double cosine_ddot =
        a.acceleration.dot(b.value) + 2.0 * a.rate.dot(b.rate) + a.value.dot(b.acceleration);
    const double rate = -cosine_dot / sine;
    QuantityValue out = with_accelerations(
        {elementary::atan2(sine, cosine), rate, (-cosine_ddot - cosine * rate * rate) / sine}, 2);
    if (sine > 0.0) { return out; }
    // parallel: the angle has a corner here
    out.derivatives = {out.derivatives[0], QuantityValue::kNone, QuantityValue::kNone};
    out.absences = {Absence::none, Absence::singular, Absence::singular};
    return out;
}

QuantityValue Evaluation::operator()(const EnergyQuantity& q) const {
    if (!instant_->scene) { return absent(Absence::no_masses); }
    const auto part_of = [&](const Energy& energy) {
        switch (q.part) {
            case EnergyPart::kinetic: return energy.kinetic;
            case EnergyPart::potential: return energy.potential;
            case EnergyPart::sum: break;
        }
        return energy.kinetic + energy.potential;
    };
    const Centroidal& scene = *instant_->scene;
    const bool moves_on = instant_->acceleration || instant_->centroidal_acceleration;
    double rate = QuantityValue::kNone;
    if (highest_ > 0 && moves_on) {
        rate = part_of(energy_rate_of(
            scene, scene.to_centroidal(instant_->state),
            scene.to_centroidal(instant_->state, instant_->velocity),
            instant_->find_centroidal_acceleration()));
    }
    return with_accelerations({part_of(instant_->find_energy()), rate, QuantityValue::kNone}, 1);
}

const Reaction* Evaluation::reaction_of(int joint, int driver, Absence& why) const {
    if (!instant_->scene) {
        why = Absence::no_masses;
    } else if (!instant_->acceleration && !instant_->centroidal_acceleration) {
        why = Absence::no_acceleration;
    } else if (instant_->reactions().residual_of_loads > kNoMotion) {
        why = Absence::no_motion_of_it;
    } else {
        why = Absence::not_there;
        for (const Reaction& reaction : instant_->reactions().reactions) {
            if (reaction.joint == joint && reaction.driver == driver) { return &reaction; }
        }
    }
    return nullptr;
}

QuantityValue Evaluation::operator()(const ReactionQuantity& q) const {
    QuantityValue out;
    const Reaction* reaction = reaction_of(q.joint, q.driver, out.absences[0]);
    if (reaction == nullptr) { return out; }
    const bool force = q.part == WrenchPart::force;
    const Vec3& vector = force ? reaction->wrench.force : reaction->wrench.torque;
    const auto& unique = force ? reaction->force_unique_global : reaction->torque_unique_global;
    const bool is_size = q.component > 2;
    const bool known = is_size ? std::ranges::all_of(unique, std::identity{}) : unique[at(q.component)];
    out.absences[0] = known ? Absence::none : Absence::not_unique;
    if (known) { out.derivatives[0] = is_size ? vector.norm() : vector(q.component); }
    return out;
}

QuantityValue Evaluation::operator()(const EffortQuantity& q) const {
    QuantityValue out;
    const Reaction* reaction = reaction_of(-1, q.driver, out.absences[0]);
    if (reaction == nullptr) { return out; }
    out.absences[0] = reaction->unique() ? Absence::none : Absence::not_unique;
    if (reaction->unique()) { out.derivatives[0] = reaction->effort; }
    return out;
}

QuantityValue Evaluation::operator()(const ParameterErrorQuantity& q) const {
    QuantityValue out;
    out.derivatives[0] = instant_->state.p[at(q.body)].norm() - 1.0;
    return out;
}

QuantityValue Evaluation::operator()(const SingularValueQuantity& /*q*/) const {
    QuantityValue out;
    out.derivatives[0] = instant_->rank().last_value();
    return out;
}

QuantityValue Evaluation::operator()(const PairConditionQuantity& q) const {
    QuantityValue out;
    out.absences[0] = Absence::not_there;
    const System& system = *instant_->system;
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        if (c.joint != q.joint || c.role != q.role) { continue; }
        const double found =
            explain_choice(system, static_cast<int>(k), instant_->state, c.dropped).form_condition;
        const bool lost = !std::isfinite(found);
        out.absences[0] = lost ? Absence::rank_lost : Absence::none;
        if (!lost) { out.derivatives[0] = found; }
    }
    return out;
}

}  // namespace

QuantityValue evaluate(const Quantity& quantity, const Instant& instant, int highest) {
    return std::visit(Evaluation(instant, highest), quantity);
}

}  // namespace jw
