#include "core/motion/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

namespace {

constexpr unsigned kSeed = 1;
/// Least scale of a body's speed and acceleration, as a share of those of the fastest body: rounding is
/// passed on from body to body through the reactions.
constexpr double kFloor = 1e-3;

/// Accelerations that take ten days for one extent [1/s²]: if nothing moves, all accelerations are rounding.
constexpr double kUnseen = 1e-12;

/// Residual below which the drift is not evaluated, since rounding explains it.
constexpr double kSurelyRounding = 1e-9;

bool asks_for_parameter(const LinkEquation& equation) {
    const auto* driven = std::get_if<Driven>(&equation.primitive);
    const auto* asked = driven != nullptr ? std::get_if<CoordinateMeasure>(&driven->measure) : nullptr;
    return asked != nullptr && asked->coordinate >= 3;
}

/// Largest work that a force can do along a motion of this size, for any point of application and any axis of
/// rotation. If a body is pushed across its freedoms and turned along them, all products are rounding.
double size_of(const BodyForce& force, const Vec3& way, const Vec3& turn, double extent) {
    return (force.f.lpNorm<1>() * extent + force.n_local.lpNorm<1>()) *
           (way.lpNorm<1>() / extent + turn.lpNorm<1>());
}

}  // namespace

Certificate::Certificate(const Centroidal& scene, const Baumgarte& baumgarte, int shares)
    : scene_(&scene),
      baumgarte_(baumgarte),
      shares_(at(shares)),
      extent_(extent(scene.mechanism)),
      moving_(moving_bodies_of(scene.mechanism)),
      links_(links_of(scene.mechanism)),
      bodies_(scene.mechanism.bodies.size()),
      loaded_(bodies_.size()),
      acceleration_(bodies_.size(), 0.0),
      speed_(bodies_.size(), 0.0),
      forces_(bodies_.size()),
      random_(kSeed) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = scene.mechanism.bodies[b];
        loaded_[b] = kinematics_at<OmegaLocal>(body.r, body.p);
        bodies_[b].r = loaded_[b].r;
        bodies_[b].p = loaded_[b].p;
        bodies_[b].A = loaded_[b].A;
    }
    std::erase_if(links_, [&](const Link& link) {
        return scene.mechanism.bodies[at(link.body_i)].fixed && scene.mechanism.bodies[at(link.body_j)].fixed;
    });
    find_loaded();
    measure_units();
}

void Certificate::find_loaded() {
    const Loads& loads = scene_->loads;
    std::vector<bool> counts(bodies_.size(), false);
    const auto mark = [&](const auto& load) { counts[at(load.body)] = true; };
    const auto mark_both = [&](const auto& load) {
        counts[at(load.body_i)] = counts[at(load.body_j)] = true;
    };
    std::ranges::for_each(loads.forces, mark);
    std::ranges::for_each(loads.torques, mark);
    for (const AppliedTorque& torque : loads.torques) {
        if (torque.against >= 0) { counts[at(torque.against)] = true; }
    }
    std::ranges::for_each(loads.springs, mark_both);
    for_each_angle(loads, mark_both);
    for_each_measuring<Spring>(loads, mark_both);
    std::ranges::for_each(loads.bushings, mark_both);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        if (counts[at(moving_[m])]) { loaded_moving_.push_back(static_cast<int>(m)); }
    }
}

/// Computes the units of the rows at the start pose: their change when bodies move by one extent, or turn by
/// 1 rad.
void Certificate::measure_units() {
    for (const Link& link : links_) {
        first_row_.push_back(inverse_unit_.size());
        for (const LinkEquation& equation : link.equations) {
            needs_p_ = needs_p_ || asks_for_parameter(equation);
            visit_rows<Content::jacobian>(
                equation.primitive, loaded_[at(link.body_i)], loaded_[at(link.body_j)], 0.0,
                [&](const auto& jet, double, double) {
                    using Jet = std::decay_t<decltype(jet)>;
                    for (int k = 0; k < Jet::kDim; ++k) {
                        double square = 0.0;
                        const auto add = [&](const auto& block) {
                            square += block.template leftCols<3>().row(k).squaredNorm() * extent_ * extent_ +
                                      block.template rightCols<3>().row(k).squaredNorm();
                        };
                        if constexpr ((Jet::kSides & kBodyI) != 0) { add(jet.block_i); }
                        if constexpr ((Jet::kSides & kBodyJ) != 0) { add(jet.block_j); }
                        inverse_unit_.push_back(square > 0.0 ? 1.0 / std::sqrt(square) : 1.0);
                    }
                });
        }
    }
}

std::span<const double> Certificate::draw(int count) {
    drawn_.resize(at(count));
    constexpr double half = 0.5 * std::minstd_rand::max();
    for (double& number : drawn_) { number = static_cast<double>(random_()) / half - 1.0; }
    return drawn_;
}

/// Sets the bodies' accelerations to q̈ + δ, with δ scaled to the size of q̈.
void Certificate::set_bodies(std::span<const ProbedBody> bodies) {
    const double per_extent = 1.0 / extent_;
    const auto size = [&](const Vec3& way, const Vec3& turn) {
        return way.lpNorm<1>() * per_extent + turn.lpNorm<1>();
    };
    fastest_ = 0.0;
    largest_ = kUnseen / kFloor;
    double moved = 0.0;
    double free = 0.0;
    for (const ProbedBody& body : bodies) {
        moved = std::max(moved, size(body.r_ddot, body.alpha));
        free = std::max(free, size(body.free_way, body.free_turn));
    }
    const double share = free > 0.0 ? (moved > 0.0 ? moved : 1.0) / free : 0.0;
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        const ProbedBody& from = bodies[m];
        const auto b = at(moving_[m]);
        auto& body = bodies_[b];
        body.r = from.r;
        body.A = from.A;
        body.r_dot = from.r_dot;
        body.omega = from.omega;
        body.r_ddot = from.r_ddot + share * from.free_way;
        body.alpha = from.alpha + share * from.free_turn;
        if (needs_p_) {
            body.p = from.p;
            body.p_dot = p_dot_of_omega_global(from.p, from.omega);
            body.p_bias = p_ddot_of_omega_global(from.p, from.omega, body.alpha);
        }
        speed_[b] = size(from.r_dot, from.omega);
        acceleration_[b] = size(from.r_ddot, from.alpha) + share * size(from.free_way, from.free_turn) +
                           speed_[b] * speed_[b];
        fastest_ = std::max(fastest_, speed_[b]);
        largest_ = std::max(largest_, acceleration_[b]);
    }
}

void Certificate::set_forces(double t, std::span<const ProbedBody> bodies) {
    for (const int m : loaded_moving_) {
        const ProbedBody& from = bodies[at(m)];
        auto& body = loaded_[at(moving_[at(m)])];
        body.r = from.r;
        body.p = from.p;
        body.A = from.A;
        body.r_dot = from.r_dot;
        OmegaLocal::set_motion(body, from.A.transpose() * from.omega);
    }
    std::ranges::fill(forces_, BodyForce{});
    add_forces(scene_->loads, loaded_, t, forces_);
    // in a scene constrained to rest, accelerations are rounding errors of those that the forces would cause
    for (const int body : moving_) {
        const MassProperties& own = *scene_->loads.masses[at(body)];
        const BodyForce& Q = forces_[at(body)];
        largest_ = std::max(
            largest_, Q.f.lpNorm<1>() / (own.mass * extent_) + Q.n_local.lpNorm<1>() / own.J_local.trace());
    }
}

double Certificate::force_residual(std::span<const ProbedBody> bodies) const {
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        const ProbedBody& body = bodies[m];
        const auto b = at(moving_[m]);
        const MassProperties& own = *scene_->loads.masses[b];
        const Vec3 omega_local = body.A.transpose() * body.omega;
        const Vec3 free_turn_local = body.A.transpose() * body.free_turn;
        const BodyForce Q{forces_[b].f, forces_[b].n_local + gyroscopic_torque(own.J_local, omega_local)};
        const BodyForce M_q_ddot{own.mass * body.r_ddot, own.J_local * (body.A.transpose() * body.alpha)};
        sum += body.free_way.dot(M_q_ddot.f - Q.f) + free_turn_local.dot(M_q_ddot.n_local - Q.n_local);
        // next to driven bodies, free ones may have accelerations that are only rounding errors
        const double inertia = own.mass * extent_ * extent_ + own.J_local.trace();
        const double moved = body.free_way.lpNorm<1>() / extent_ + free_turn_local.lpNorm<1>();
        size += size_of(M_q_ddot, body.free_way, free_turn_local, extent_) +
                size_of(Q, body.free_way, free_turn_local, extent_) + kFloor * largest_ * inertia * moved;
    }
    return size > 0.0 ? std::abs(sum) / size : 0.0;
}

template <class F>
void Certificate::for_each_row(double t, F&& f) const {
    for (std::size_t n = share_; n < links_.size(); n += shares_) {
        const Link& link = links_[n];
        const double* inverse_unit = &inverse_unit_[first_row_[n]];
        for (const LinkEquation& equation : link.equations) {
            visit_rows<Content::motion>(
                equation.primitive, bodies_[at(link.body_i)], bodies_[at(link.body_j)], t,
                [&](const auto& jet, double f_dot, double f_ddot) {
                    for (int k = 0; k < jet.kDim; ++k) {
                        const double by_unit = *inverse_unit++;
                        if (((equation.left_out >> k) & 1U) != 0) { continue; }
                        f(link, equation, by_unit, jet.value(k), jet.rate(k) - f_dot, jet.bias(k) - f_ddot,
                          std::abs(f_ddot));
                    }
                });
        }
    }
}

/// Largest |Φ|, and |Φ̇| divided by the speed of the fastest body.
double Certificate::drift(double t) const {
    double drift = 0.0;
    for_each_row(
        t, [&](const Link&, const LinkEquation&, double by_unit, double phi, double phi_dot, double, double) {
            drift = std::max(drift, std::abs(phi) * by_unit);
            if (fastest_ > 0.0) { drift = std::max(drift, std::abs(phi_dot) * by_unit / fastest_); }
        });
    return drift;
}

AccelerationResidual Certificate::check(double t, std::span<const ProbedBody> bodies) {
    set_bodies(bodies);
    set_forces(t, bodies);
    AccelerationResidual out;
    out.forces = force_residual(bodies);
    const double alpha = 2.0 * baumgarte_.alpha;
    const double beta = baumgarte_.beta * baumgarte_.beta;
    for_each_row(
        t, [&](const Link& link, const LinkEquation& equation, double by_unit, double phi, double phi_dot,
               double phi_ddot, double f_ddot) {
            const auto of_both = [&](const std::vector<double>& size) {
                return size[at(link.body_i)] + size[at(link.body_j)];
            };
            const double size = of_both(acceleration_) + kFloor * largest_ + f_ddot * by_unit +
                                alpha * (of_both(speed_) + kFloor * fastest_);
            const double off = std::abs(phi_ddot + alpha * phi_dot + beta * phi) * by_unit;
            // NaN fails every comparison
            if (off <= out.constraints * size) { return; }
            out.constraints = size > 0.0 ? off / size : 0.0;
            out.joint = link.joint;
            out.driver = equation.driver;
        });
    if (!(std::max(out.constraints, out.forces) < kSurelyRounding)) { out.drift = drift(t); }
    share_ = (share_ + 1) % shares_;
    return out;
}

AccelerationResidual Certificate::check(
    MotionEquations& equations, MotionEquations& in_bodies, double t, const std::vector<double>& y,
    const std::vector<double>& y_dot) {
    probed_.resize(moving_.size());
    equations.motion_of_bodies(t, y.data(), y_dot.data(), probed_);
    if (!equations.free_motion(t, y.data(), draw(equations.velocities()), probed_)) {
        flat_.resize(at(kNumbersPerBody) * moving_.size());
        equations.to_flat(y.data(), flat_.data());
        // rows that were independent at another pose may be redundant at this one
        in_bodies.choose_rows(t, flat_.data());
        in_bodies.free_motion(t, flat_.data(), draw(in_bodies.velocities()), probed_);
    }
    return check(t, probed_);
}

}  // namespace jw
