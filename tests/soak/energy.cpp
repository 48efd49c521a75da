#include <array>
#include <cstdio>

#include "core/motion/reactions.hpp"
#include "tests/soak/forms.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/soak/ways.hpp"
#include "tests/support/generators/to_model.hpp"

/// Power and energy: the bodies take up the energy that forces and drivers put in.
namespace jw::test {

namespace {

namespace general = reference::general;
using reference::Real;

constexpr double kDuration = 0.1;
// as in methods.cpp: global errors of a run with tolerance 1e-9, in the unit of power times the duration
constexpr double kAllowed = 1e-6;

/// Power of all applied loads, each from its definition [W]. The twists of turning springs are counted on
/// from call to call.
class AppliedPower {
public:
    explicit AppliedPower(const general::Model& model)
        : model_(model), twists_(model.turning_springs.size()) {}

    Real at(const general::PlacedBodies& placed, Real t) {
        Real power = 0.0L;
        for (std::size_t b = 0; b < placed.size(); ++b) {
            if (!model_.bodies[b].fixed) { power += model_.bodies[b].mass * model_.gravity.dot(placed[b].v); }
        }
        for (const general::Force& f : model_.forces) {
            const reference::Vec3 along = direction(placed, f.point.body, f.local, f.direction);
            power += size(f.magnitude, t) * along.dot(general::point_of(placed, f.point).rate);
        }
        for (const general::Torque& n : model_.torques) {
            const reference::Vec3 about = direction(placed, n.body, n.local, n.direction);
            const auto omega = [&](int body) { return placed[static_cast<std::size_t>(body)].omega; };
            power += size(n.magnitude, t) * about.dot(omega(n.body));
            if (n.against >= 0) { power -= size(n.magnitude, t) * about.dot(omega(n.against)); }
        }
        for (const general::Spring& s : model_.springs) { power += power_of(s, placed); }
        for (std::size_t k = 0; k < twists_.size(); ++k) { power += turning_power(k, placed); }
        return power;
    }

private:
    static Real resistance(const general::Friction& f, Real rate) {
        return f.size * rate / std::sqrt(rate * rate + f.speed * f.speed);
    }
    static Real law(const std::optional<general::FormulaTree>& f, Real value, Real rate) {
        return f ? general::value_of(*f, {{value}, {rate}}).value : 0.0L;
    }
    static Real size(const general::TimeFunction& f, Real t) { return general::time_function(f, t).value; }
    static reference::Vec3 direction(
        const general::PlacedBodies& placed, int body, bool local, const reference::Vec3& v) {
        return local ? reference::Vec3(placed[static_cast<std::size_t>(body)].A * v) : v;
    }
    /// -(k (ℓ - ℓ0) + c ℓ̇) ℓ̇, with 2 ℓ ℓ̇ the rate of ℓ².
    static Real power_of(const general::Spring& s, const general::PlacedBodies& placed) {
        if (s.axis) {
            const general::Taylor way = general::dot(
                general::direction_of(placed, *s.axis),
                general::point_of(placed, s.j) - general::point_of(placed, s.i));
            const Real pull = s.stiffness * (way.value - s.free_length) + s.damping * way.rate;
            return -(pull + resistance(s.friction, way.rate) + law(s.law, way.value, way.rate)) * way.rate;
        }
        const general::Taylor square = general::measured(general::SquaredDistance{s.i, s.j}, placed);
        const Real length = std::sqrt(square.value);
        if (!(length > 0.0L)) { return 0.0L; }
        const Real rate = square.rate / (2.0L * length);
        const Real pull = s.stiffness * (length - s.free_length) + s.damping * rate;
        return -(pull + resistance(s.friction, rate) + law(s.law, length, rate)) * rate;
    }
    Real turning_power(std::size_t k, const general::PlacedBodies& placed) {
        const general::TurningSpring& s = model_.turning_springs[k];
        const general::Taylor angle = general::angle_value(s.angle, placed);
        twists_[k] += std::remainder(angle.value - s.free_angle - twists_[k], 2.0L * reference::kPi);
        // the torque acts about the axis on body i: where the two axes differ, its rate is not the angle's
        const auto omega = [&](int body) { return placed[static_cast<std::size_t>(body)].omega; };
        const reference::Vec3 axis = general::direction_of(placed, s.angle.s).value;
        const Real turning = axis.dot(omega(s.angle.u_j.body) - omega(s.angle.u_i.body));
        const Real torque = s.stiffness * twists_[k] + s.damping * angle.rate;
        const Real added = law(s.law, twists_[k] + s.free_angle, angle.rate);
        return -(torque + resistance(s.friction, angle.rate) + added) * turning;
    }

    const general::Model& model_;
    std::vector<Real> twists_;
};

/// Σ effort × prescribed rate of all drivers.
Real power_of_drivers(const Generated& generated, const Reactions& reactions, double t) {
    Real power = 0.0L;
    for (const Reaction& reaction : reactions.reactions) {
        if (reaction.driver < 0) { continue; }
        const Driver& driver = generated.mechanism.drivers[at(reaction.driver)];
        const general::Equation equation = equation_of_driver(generated.mechanism, driver, 0);
        power += reaction.effort * general::time_function(equation.target, t).rate;
    }
    return power;
}

/// d/dt of ½ m v² + ½ ω · J ω; the turning of J does no work.
Real kinetic_rate(
    const general::Model& model, const general::PlacedBodies& placed, const Motion& accelerations) {
    Real rate = 0.0L;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        if (model.bodies[b].fixed) { continue; }
        const reference::Vec3 omega = placed[b].A.transpose() * placed[b].omega;
        rate += model.bodies[b].mass * placed[b].v.dot(accelerations.r_dot[b].cast<long double>());
        rate += omega.dot(model.bodies[b].J * accelerations.omega_local[b].cast<long double>());
    }
    return rate;
}

/// Power that accelerations of this size [1/s²] would have if they were those of all bodies and along the
/// fastest velocity there is; a scene at rest moves by its length in a second, as rounding would see it.
double size_of_power(
    const general::Model& model, const general::PlacedBodies& placed, double accelerated, double length) {
    long double mass = 0.0L;
    long double fastest = 1.0L;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        if (!model.bodies[b].fixed) { mass += model.bodies[b].mass; }
        fastest = std::max({fastest, placed[b].v.norm() / length, placed[b].omega.norm()});
    }
    return static_cast<double>(mass * fastest) * accelerated * length * length;
}

std::string misses(const std::string& where, const char* what, double off) {
    char text[200];
    std::snprintf(text, sizeof text, "%s differs from what is put in by %.2g of its size", what, off);
    return where + ": " + text;
}

/// Checks the balance of power at the start, in every form of the equations.
Verdict at_start(const Generated& generated, general::Mechanics& reference, double accelerated) {
    const Centroidal scene = centroidal(generated.mechanism, generated.loads);
    const general::Model& model = reference.model();
    const general::PlacedBodies placed = reference.bodies_at(reference.start());
    AppliedPower applied(model);
    const Real loads = applied.at(placed, 0.0L);
    const double size = size_of_power(model, placed, accelerated, generated.length);
    // accelerations.cpp and reactions.cpp check the number of digits; a term that is missing or has the wrong
    // sign is off by its own size
    const double c = generated.condition;
    const double limit = 1e-6 + 1e-11 * c * (c + std::pow(10.0, generated.recipe.near));
    for (const Form& form : accelerations_in_all_forms(scene)) {
        const Reactions reactions = find_reactions(
            scene, 0.0, start_state(scene.mechanism), start_motion(scene.mechanism), form.accelerations);
        const Real put_in = loads + power_of_drivers(generated, reactions, 0.0);
        const Real taken = kinetic_rate(model, placed, form.accelerations);
        const auto off = static_cast<double>(std::abs(taken - put_in)) / size;
        if (!(off <= limit)) { return fails(misses(form.name, "the rate of kinetic energy", off)); }
    }
    return holds();
}

// number of Gauss quadratures of eight points along the motion: short springs that swing past their end need
// as many
constexpr int kParts = 4;
constexpr std::array kGauss{
    std::pair{0.1834346424956498, 0.3626837833783620}, std::pair{0.5255324099163290, 0.3137066458778873},
    std::pair{0.7966664774136267, 0.2223810344533745}, std::pair{0.9602898564975363, 0.1012285362903763}};

struct Samples {
    std::vector<double> times;
    std::vector<double> weights;  ///< of the power there [s]
};

Samples samples_of(const Generated& generated, int parts) {
    std::vector<double> ends{0.0};
    for (int k = 1; k <= parts; ++k) { ends.push_back(k * kDuration / parts); }
    ends = with_events(generated, ends);
    Samples out{{0.0}, {0.0}};
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double middle = 0.5 * (ends[k] + ends[k - 1]);
        const double half = 0.5 * (ends[k] - ends[k - 1]);
        const auto add = [&](double place, double weight) {
            out.times.push_back(middle + half * place);
            out.weights.push_back(half * weight);
        };
        for (std::size_t n = kGauss.size(); n-- > 0;) { add(-kGauss[n].first, kGauss[n].second); }
        for (const auto& [place, weight] : kGauss) { add(place, weight); }
        add(1.0, 0.0);
    }
    return out;
}

struct Balance {
    double off = 0.0;     ///< relative to the size of the energy
    std::string refused;  ///< why the balance cannot be judged
};

Balance balance_of(
    const Generated& generated, general::Mechanics& reference, const Way& way, double accelerated,
    int parts) {
    const Samples samples = samples_of(generated, parts);
    Simulation simulation(generated.mechanism, generated.loads, way.settings);
    const general::PlacedBodies before = reference.bodies_at(reference.start());
    AppliedPower applied(reference.model());
    Real put_in = 0.0L;
    Real first = 0.0L;
    Real last = 0.0L;
    std::size_t k = 0;
    Balance out;
    const auto outcome = simulation.run(samples.times, [&](double t, const std::vector<double>& y) {
        const general::PlacedBodies placed = placed_of(simulation.scene(), y, before);
        const reference::VecX state = reference.state_of(placed, t);
        last = reference.kinetic_energy(state);
        if (k == 0) { first = last; }
        const general::Accelerations a = reference.accelerations_at(state);
        if (!(a.condition < 1e3L) || a.rank != generated.rank) { out.refused = "singular on the way"; }
        State pose = start_state(simulation.scene().mechanism);
        Motion motion = start_motion(simulation.scene().mechanism);
        unpack(y.data(), moving_bodies_of(simulation.scene().mechanism), pose, motion);
        const Reactions reactions =
            find_reactions(simulation.scene(), t, pose, motion, simulation.acceleration(t, y));
        put_in += samples.weights[k++] * (applied.at(placed, t) + power_of_drivers(generated, reactions, t));
    });
    if (outcome.failure) { out.refused = "the run ends early"; }
    const double size = size_of_power(reference.model(), before, accelerated, generated.length) * kDuration;
    out.off = static_cast<double>(std::abs(last - first - put_in)) / size;
    return out;
}

Verdict along_motion(const Generated& generated, general::Mechanics& reference, double accelerated) {
    // both ways of explicit-8
    for (const Way& way : {ways()[0], ways()[1]}) {
        Way tight = way;
        tight.settings.tolerance = 1e-9;
        tight.settings.most_steps = 5000;
        Balance found = balance_of(generated, reference, tight, accelerated, kParts);
        if (!found.refused.empty()) { return holds(); }
        if (found.off <= kAllowed) { continue; }
        // an error that vanishes at a tighter tolerance is not a fault
        tight.settings.tolerance = 1e-11;
        found = balance_of(generated, reference, tight, accelerated, kParts);
        if (found.off <= kAllowed) { continue; }
        // at the end of a reach, or at a singular pose, power grows without bound: errors of the quadrature
        // change with the number of its parts, errors of the motion do not
        const Balance finer = balance_of(generated, reference, tight, accelerated, 4 * kParts);
        if (!finer.refused.empty() || std::abs(finer.off - found.off) > 0.1 * found.off) { return holds(); }
        return fails(misses(way.name, "kinetic energy", finer.off));
    }
    return holds();
}

}  // namespace

Verdict power_balances(const Generated& generated) {
    if (!(generated.condition < 1e3)) { return not_asked("too near to a singular pose"); }
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    const double accelerated = size_of(reference.accelerations_at(reference.start()), generated.length);
    const Verdict start = at_start(generated, reference, accelerated);
    // one in eight is also moved, if it is slow enough for the quadrature
    const bool is_moved = generated.recipe.seed % 8 == 0 && accelerated < 300.0;
    if (start.kind != Verdict::Kind::holds || !is_moved || keeps_rows_by_hand(generated.mechanism)) {
        return start;
    }
    return along_motion(generated, reference, accelerated);
}

}  // namespace jw::test
