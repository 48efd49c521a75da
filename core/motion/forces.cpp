#include "core/motion/forces.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/jets/drivers.hpp"

namespace jw {

namespace {

using Bodies = std::span<const BodyKinematics<OmegaLocal>>;
using Forces = std::span<BodyForce>;

/// Adds a force `f` (global) at a point of a body.
void push(Bodies bodies, Forces forces, int body, const Vec3& point_local, const Vec3& f) {
    forces[at(body)].f += f;
    forces[at(body)].n_local += point_local.cross(bodies[at(body)].A.transpose() * f);
}

/// Vector between the two points of a spring or a bushing, and its rate.
SpringSpan between_points(const auto& ends, Bodies bodies) {
    const auto& i = bodies[at(ends.body_i)];
    const auto& j = bodies[at(ends.body_j)];
    return {
        j.r + j.A * ends.P_j_local - i.r - i.A * ends.P_i_local,
        j.r_dot + j.A_dot * ends.P_j_local - i.r_dot - i.A_dot * ends.P_i_local};
}

/// Distance between a spring's ends, or displacement along its axis, and its rate.
struct Stretch {
    double length = 0.0;              ///< [m]
    Vec3 along = Vec3::Zero();        ///< unit vector from i to j, zero where the ends coincide; or the axis
    double rate = 0.0;                ///< [m/s]
    Vec3 end_i_local = Vec3::Zero();  ///< point of body i that the force acts on [m]
};
Stretch stretch_of(const Spring& spring, Bodies bodies) {
    const auto& i = bodies[at(spring.body_i)];
    const auto [d, d_dot] = span_of(spring, bodies);
    Stretch out;
    out.end_i_local = spring.P_i_local;
    if (spring.s_i_local) {
        out.along = i.A * *spring.s_i_local;
        out.length = out.along.dot(d);
        out.rate = out.along.dot(d_dot) + (i.A_dot * *spring.s_i_local).dot(d);
        // ∂ℓ/∂(turn of i) = s x d: the axis turns with body i, so the force acts on it at the point of j
        out.end_i_local += i.A.transpose() * d;
        return out;
    }
    out.length = d.norm();
    if (out.length > 0.0) { out.along = d / out.length; }
    out.rate = out.along.dot(d_dot);
    return out;
}

/// θ - θ0 with the turns nearest to the last value [rad], and θ̇ [rad/s].
struct Twist {
    double angle = 0.0;
    double rate = 0.0;
};
Twist twist_of(const RotationalSpring& spring, Bodies bodies) {
    const auto angle = measured<Content::motion>(
        spring.angle, bodies[at(spring.body_i)], bodies[at(spring.body_j)], Theta{});
    const double change = angle.value(0) - spring.free_angle - spring.twist_before;
    return {spring.twist_before + std::remainder(change, 2.0 * std::numbers::pi), angle.rate(0)};
}

/// Displacement and rotation vector of a bushing, along and about its axes.
struct Yielding {
    Vec3 d;               ///< [m]
    Vec3 d_dot;           ///< [m/s]
    Vec3 phi;             ///< rotation vector [rad], shorter than π
    Vec3 phi_dot;         ///< [rad/s]
    Mat3 phi_by_turning;  ///< ∂φ̇/∂ω of the axes in j against those in i
    Mat3 axes;            ///< axes in body i, columns, global
    Vec3 d_global;        ///< [m]
};

/// Rotation vector of a rotation matrix; of half a turn, one of the two.
Vec3 rotation_vector(const Mat3& R) {
    // 4 e0 e and 4 e0² of its Euler parameters
    const Vec3 e(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    const double length = e.norm();
    const double angle = 2.0 * elementary::atan2(length, 1.0 + R.trace());
    if (length > 0.0) { return angle / length * e; }
    if (R.trace() > 0.0) { return Vec3::Zero(); }
    // half a turn: R + I is 2 n nᵀ
    Eigen::Index largest = 0;
    R.diagonal().maxCoeff(&largest);
    return std::numbers::pi * (R.col(largest) + Vec3::Unit(largest)).normalized();
}

/// ∂φ̇/∂ω = I - φ̃/2 + c φ̃² with c = (1 - (φ/2) cot(φ/2)) / φ². Where φ is so small that c is wrong, c φ̃² is
/// as small as rounding.
Mat3 rotation_vector_rate(const Vec3& phi) {
    const double square = phi.squaredNorm();
    const Mat3 cross = tilde(phi);
    const Mat3 first_order = Mat3::Identity() - 0.5 * cross;
    if (square == 0.0) { return first_order; }
    const double half = 0.5 * std::sqrt(square);
    const auto [sine, cosine] = elementary::sine_and_cosine(half);
    return first_order + (1.0 - half * cosine / sine) / square * (cross * cross);
}

Yielding yielding_of(const Bushing& bushing, Bodies bodies) {
    const auto& i = bodies[at(bushing.body_i)];
    const auto& j = bodies[at(bushing.body_j)];
    const auto [d, d_dot] = between_points(bushing, bodies);
    Yielding out;
    out.axes = i.A * bushing.axes_i_local;
    out.d_global = d;
    const Mat3 axes_dot = i.A_dot * bushing.axes_i_local;
    const Mat3 axes_j = j.A * bushing.axes_j_local;
    out.d = out.axes.transpose() * d;
    out.d_dot = out.axes.transpose() * d_dot + axes_dot.transpose() * d;
    const Mat3 R = out.axes.transpose() * axes_j;
    const Mat3 R_dot =
        axes_dot.transpose() * axes_j + out.axes.transpose() * (j.A_dot * bushing.axes_j_local);
    const Mat3 turning = R_dot * R.transpose();
    out.phi = rotation_vector(R);
    out.phi_by_turning = rotation_vector_rate(out.phi);
    out.phi_dot = out.phi_by_turning * Vec3(turning(2, 1), turning(0, 2), turning(1, 0));
    return out;
}

void add_bushing(const Bushing& bushing, Bodies bodies, Forces forces) {
    const auto& i = bodies[at(bushing.body_i)];
    const Yielding y = yielding_of(bushing, bodies);
    const Vec3 pull = bushing.stiffness.cwiseProduct(y.d) + bushing.damping.cwiseProduct(y.d_dot);
    const Vec3 f = y.axes * pull;
    // the axes turn with body i, so the force acts on it at the point of j
    push(bodies, forces, bushing.body_i, bushing.P_i_local + i.A.transpose() * y.d_global, f);
    push(bodies, forces, bushing.body_j, bushing.P_j_local, -f);
    const Vec3 twist =
        bushing.rotational_stiffness.cwiseProduct(y.phi) + bushing.rotational_damping.cwiseProduct(y.phi_dot);
    const Vec3 n = y.axes * (y.phi_by_turning.transpose() * twist);
    forces[at(bushing.body_i)].n_local += i.A.transpose() * n;
    forces[at(bushing.body_j)].n_local -= bodies[at(bushing.body_j)].A.transpose() * n;
}

/// t, and the values and rates of what a law reads.
using LawVariables = std::array<double, ScalarFormula::kMostVariables>;
LawVariables variables_of(const LoadLaw& law, Bodies bodies, double t) {
    LawVariables out{t};
    double* next = &out[1];
    for (const LoadLaw::Quantity& quantity : law.quantities) {
        const auto put = [&](double value, double rate) {
            *next++ = value;
            *next++ = rate;
        };
        if (const auto* angle = std::get_if<RotationalSpring>(&quantity.measured)) {
            const Twist twist = twist_of(*angle, bodies);
            put(twist.angle, twist.rate);
        } else {
            const Stretch stretch = stretch_of(std::get<Spring>(quantity.measured), bodies);
            put(stretch.length, stretch.rate);
        }
    }
    return out;
}

/// Magnitude of a force or a torque.
double magnitude_of(const auto& load, Bodies bodies, double t) {
    const double of_time = load.magnitude.at(t).f;
    return load.law ? of_time + value_of(*load.law, bodies, t) : of_time;
}

void add_applied(const Loads& loads, Bodies bodies, double t, Forces forces) {
    for (const AppliedForce& force : loads.forces) {
        const Vec3 f = magnitude_of(force, bodies, t) * force.direction;
        const bool turns = force.frame == Frame::local;
        push(
            bodies, forces, force.body, force.point_local, turns ? (bodies[at(force.body)].A * f).eval() : f);
    }
    for (const AppliedTorque& torque : loads.torques) {
        const Vec3 n = magnitude_of(torque, bodies, t) * torque.direction;
        const bool turns = torque.frame == Frame::local;
        const Vec3 n_local = turns ? n : (bodies[at(torque.body)].A.transpose() * n).eval();
        forces[at(torque.body)].n_local += n_local;
        if (torque.against < 0) { continue; }
        forces[at(torque.against)].n_local -=
            bodies[at(torque.against)].A.transpose() * (bodies[at(torque.body)].A * n_local);
    }
}

double force_of(const std::optional<ScalarFormula>& law, double value, double rate, double t) {
    return law ? law->at(std::array{value, rate, t}) : 0.0;
}

/// Energy of a spring's law.
double energy_of_law(const auto& spring, double from, double to) {
    return spring.law && !depends_on_time(spring) ? spring.law->integral(from, to) : 0.0;
}

/// Calls `f` with each formula of a load, the values of its variables and the index of t.
void for_each_formula(auto& loads, Bodies bodies, double t, auto&& f) {
    constexpr int index_in_springs = 2;
    for (auto& spring : loads.springs) {
        if (!spring.law) { continue; }
        const Stretch stretch = stretch_of(spring, bodies);
        f(*spring.law, std::array{stretch.length, stretch.rate, t}, index_in_springs);
    }
    for (auto& spring : loads.rotational_springs) {
        if (!spring.law) { continue; }
        const Twist twist = twist_of(spring, bodies);
        f(*spring.law, std::array{twist.angle + spring.free_angle, twist.rate, t}, index_in_springs);
    }
    for_each_law(
        loads, [&](auto& law) { f(law.formula, variables_of(law, bodies, t), LoadLaw::index_of_time); });
}

void add_springs(const Loads& loads, Bodies bodies, double t, Forces forces) {
    for (const Spring& spring : loads.springs) {
        const Stretch s = stretch_of(spring, bodies);
        const double pull = spring.stiffness * (s.length - spring.free_length) + spring.damping * s.rate;
        const Vec3 f =
            (pull + spring.friction.at(s.rate) + force_of(spring.law, s.length, s.rate, t)) * s.along;
        push(bodies, forces, spring.body_i, s.end_i_local, f);
        push(bodies, forces, spring.body_j, spring.P_j_local, -f);
    }
    for (const RotationalSpring& spring : loads.rotational_springs) {
        const Twist twist = twist_of(spring, bodies);
        const double torque = -spring.stiffness * twist.angle - spring.damping * twist.rate -
                              spring.friction.at(twist.rate) -
                              force_of(spring.law, twist.angle + spring.free_angle, twist.rate, t);
        const Vec3 n_local = torque * spring.angle.s_i_local;
        const auto& i = bodies[at(spring.body_i)];
        const auto& j = bodies[at(spring.body_j)];
        forces[at(spring.body_i)].n_local -= n_local;
        forces[at(spring.body_j)].n_local += j.A.transpose() * (i.A * n_local);
    }
}

}  // namespace

std::vector<BodyKinematics<OmegaLocal>> kinematics_of(const State& state) {
    std::vector<BodyKinematics<OmegaLocal>> bodies;
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        bodies.push_back(kinematics_at<OmegaLocal>(state.r[b], state.p[b]));
    }
    return bodies;
}

std::vector<BodyKinematics<OmegaLocal>> kinematics_of(const State& state, const Motion& motion) {
    std::vector<BodyKinematics<OmegaLocal>> bodies;
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        bodies.push_back(
            kinematics_at<OmegaLocal>(state.r[b], state.p[b], motion.r_dot[b], motion.omega_local[b]));
    }
    return bodies;
}

SpringSpan span_of(const Spring& spring, Bodies bodies) { return between_points(spring, bodies); }

double value_of(const LoadLaw& law, Bodies bodies, double t) {
    return law.formula.at(variables_of(law, bodies, t));
}

double size_of(const LoadLaw& law, Bodies bodies, double t) {
    return law.formula.size_at(variables_of(law, bodies, t));
}

double size_of(const Spring& spring, Bodies bodies, double t) {
    const Stretch s = stretch_of(spring, bodies);
    return spring.stiffness * (span_of(spring, bodies).d.norm() + std::abs(spring.free_length)) +
           (spring.law ? spring.law->size_at(std::array{s.length, s.rate, t}) : 0.0);
}

double size_of(const RotationalSpring& spring, double t) {
    const double angle = spring.twist_before + spring.free_angle;
    return spring.stiffness * (1.0 + std::abs(spring.twist_before) + std::abs(spring.free_angle)) +
           (spring.law ? spring.law->size_at(std::array{angle, 0.0, t}) : 0.0);
}

double size_of(const Bushing& bushing, Bodies bodies, double length) {
    const Yielding y = yielding_of(bushing, bodies);
    return bushing.stiffness.maxCoeff() * y.d.norm() +
           bushing.rotational_stiffness.maxCoeff() * (1.0 + y.phi.norm()) / length;
}

std::string unbounded_law(
    const Loads& loads, Bodies bodies, double t, std::size_t derivative, double beside) {
    std::string out;
    for_each_formula(loads, bodies, t, [&](const ScalarFormula& law, std::span<const double> now, int) {
        for (std::size_t k = 0; k < now.size(); ++k) {
            const double most = beside * std::max(1.0, std::abs(now[k]));
            const auto bounds = TimeFormula{law.along(now, k)}.taylor_bounds(now[k] - most, now[k] + most);
            if (!std::isfinite(bounds[0] + bounds[derivative])) { out = law.source; }
        }
    });
    return out;
}

bool linearise_laws(Loads& loads, Bodies bodies, double t) {
    int kinks = 0;
    for_each_formula(
        loads, bodies, t, [&](ScalarFormula& law, std::span<const double> now, int index_of_time) {
            using Kind = FormulaStep::Kind;
            std::vector<FormulaStep> steps{{Kind::number, law.at(now)}};
            for (std::size_t k = 0; k < now.size(); ++k) {
                const auto index = static_cast<int>(k);
                if (index == index_of_time || !law.uses(index)) { continue; }
                const ScalarFormula along = law.along(now, k);
                if (!along.is_smooth_at(now[k])) { ++kinks; }
                steps.insert(
                    steps.end(), {{Kind::number, along.slope_at(now[k])},
                                  {Kind::variable, static_cast<double>(k)},
                                  {Kind::number, now[k]},
                                  {Kind::difference, 0.0},
                                  {Kind::product, 0.0},
                                  {Kind::sum, 0.0}});
            }
            law.steps = std::move(steps);
        });
    return kinks == 0;
}

std::vector<ScalarFormula> laws_in_time(const Loads& loads, Bodies bodies) {
    std::vector<ScalarFormula> out;
    constexpr double any_time = 0.0;
    for_each_formula(
        loads, bodies, any_time,
        [&](const ScalarFormula& law, std::span<const double> now, int index_of_time) {
            if (law.uses(index_of_time)) { out.push_back(law.along(now, at(index_of_time))); }
        });
    return out;
}

void add_forces(const Loads& loads, Bodies bodies, double t, Forces forces) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (loads.masses[b]) { forces[b].f += loads.masses[b]->mass * loads.gravity; }
    }
    add_applied(loads, bodies, t, forces);
    add_springs(loads, bodies, t, forces);
    for (const Bushing& bushing : loads.bushings) { add_bushing(bushing, bodies, forces); }
}

void begin_turns(Loads& loads, Bodies bodies) {
    constexpr double half_turn = std::numbers::pi;
    // rounding of π typed in degrees, and of a joint that starts half a turn away
    constexpr double rounding = 1e-9;
    for_each_angle(loads, [&](RotationalSpring& spring) {
        spring.twist_before = 0.0;
        if (std::abs(spring.free_angle) <= half_turn + rounding) { return; }
        const double angle = measured<Content::motion>(
                                 spring.angle, bodies[at(spring.body_i)], bodies[at(spring.body_j)], Theta{})
                                 .value(0);
        const double start = angle <= -half_turn + rounding ? angle + 2.0 * half_turn : angle;
        spring.twist_before = start - spring.free_angle;
    });
}

void count_turns(Loads& loads, Bodies bodies) {
    for_each_angle(
        loads, [&](RotationalSpring& spring) { spring.twist_before = twist_of(spring, bodies).angle; });
}

double potential_energy(const Loads& loads, Bodies bodies) {
    double energy = 0.0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (loads.masses[b]) { energy -= loads.masses[b]->mass * loads.gravity.dot(bodies[b].r); }
    }
    for (const Spring& spring : loads.springs) {
        const double length = stretch_of(spring, bodies).length;
        const double stretch = length - spring.free_length;
        energy +=
            0.5 * spring.stiffness * stretch * stretch + energy_of_law(spring, spring.free_length, length);
    }
    for (const RotationalSpring& spring : loads.rotational_springs) {
        const double angle = twist_of(spring, bodies).angle;
        energy += 0.5 * spring.stiffness * angle * angle +
                  energy_of_law(spring, spring.free_angle, spring.free_angle + angle);
    }
    for (const Bushing& bushing : loads.bushings) {
        const Yielding y = yielding_of(bushing, bodies);
        energy += 0.5 * bushing.stiffness.dot(y.d.cwiseAbs2()) +
                  0.5 * bushing.rotational_stiffness.dot(y.phi.cwiseAbs2());
    }
    return energy;
}

Energy energy_of(const Centroidal& scene, const State& state, const Motion& motion) {
    Energy energy;
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        const auto& mass = scene.loads.masses[b];
        if (!mass) { continue; }
        energy.kinetic += kinetic_energy(*mass, motion.r_dot[b], motion.omega_local[b]);
    }
    State unit = state;
    for (Vec4& p : unit.p) { p.normalize(); }
    energy.potential = potential_energy(scene.loads, kinematics_of(unit));
    return energy;
}

}  // namespace jw
