#include <cstdio>

#include "tests/soak/forms.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/soak/ways.hpp"
#include "tests/support/generators/to_model.hpp"

/// Momentum of systems on which nothing outside acts.
namespace jw::test {

namespace {

namespace general = reference::general;

constexpr double kDuration = 0.2;
// global errors of a run with tolerance 1e-9, as in methods.cpp
constexpr double kAllowed = 1e-6;

/// Momentum and, about the origin, angular momentum; their rates likewise.
struct Momentum {
    reference::Vec3 linear = reference::Vec3::Zero();
    reference::Vec3 angular = reference::Vec3::Zero();
};

/// Larger of both, lengths in units of the scene.
double amount_of(const Momentum& a, double length) {
    return static_cast<double>(std::max(a.linear.norm() * length, a.angular.norm()));
}

double difference_of(const Momentum& a, const Momentum& b, double length) {
    return amount_of({a.linear - b.linear, a.angular - b.angular}, length);
}

Momentum momentum_of(const general::Model& model, const general::PlacedBodies& placed) {
    Momentum out;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        const general::Placed& body = placed[b];
        if (model.bodies[b].fixed) { continue; }
        const reference::Vec3 p = model.bodies[b].mass * body.v;
        out.linear += p;
        out.angular += body.c.cross(p) + body.A * (model.bodies[b].J * (body.A.transpose() * body.omega));
    }
    return out;
}

/// d/dt (c × m v + J ω) = c × m v̇ + J ω̇ + ω × J ω.
Momentum momentum_rate(
    const general::Model& model, const general::PlacedBodies& placed, const Motion& accelerations) {
    Momentum out;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        const general::Placed& body = placed[b];
        if (model.bodies[b].fixed) { continue; }
        const reference::Vec3 v_dot = accelerations.r_dot[b].cast<long double>();
        const reference::Vec3 omega_dot = body.A * accelerations.omega_local[b].cast<long double>();
        const reference::Mat3 J = body.A * model.bodies[b].J * body.A.transpose();
        out.linear += model.bodies[b].mass * v_dot;
        out.angular +=
            body.c.cross(model.bodies[b].mass * v_dot) + J * omega_dot + body.omega.cross(J * body.omega);
    }
    return out;
}

/// Momentum that a velocity (or acceleration) of one length (and one radian) in all bodies would give: the
/// scale for momenta that cancel each other and for those of a scene at rest.
double size_of_unit(const general::Model& model, const general::PlacedBodies& placed, double length) {
    long double size = 0.0L;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        if (model.bodies[b].fixed) { continue; }
        size += model.bodies[b].mass * length * (length + placed[b].c.norm()) + model.bodies[b].J.norm();
    }
    return static_cast<double>(size);
}

double fastest(const general::PlacedBodies& placed, double length) {
    long double most = 1.0L;
    for (const general::Placed& body : placed) {
        most = std::max({most, body.v.norm() / length, body.omega.norm()});
    }
    return static_cast<double>(most);
}

std::string changes(const char* of, const std::string& where, double by) {
    char text[200];
    std::snprintf(
        text, sizeof text, "%s changes by %.2g of its size, with nothing to change it: %s", of, by,
        where.c_str());
    return text;
}

/// Checks that the rates of momentum, from the accelerations, add up to zero.
Verdict rates_vanish(const Generated& generated, general::Mechanics& reference) {
    const reference::VecX y = reference.start();
    const general::Accelerations a = reference.accelerations_at(y);
    const general::PlacedBodies placed = reference.bodies_at(y);
    const double L = generated.length;
    const double size = size_of_unit(reference.model(), placed, L) * size_of(a, L);
    // accelerations.cpp checks the number of digits; a force that is not between two bodies is off by its
    // size
    const auto c = static_cast<double>(a.condition);
    const double limit = 1e-6 + 1e-11 * c * c;
    for (const Form& form : accelerations_in_all_forms(centroidal(generated.mechanism, generated.loads))) {
        const double off = amount_of(momentum_rate(reference.model(), placed, form.accelerations), L) / size;
        if (!(off <= limit)) { return fails(changes("the rate of momentum", form.name, off)); }
    }
    return holds();
}

struct Kept {
    double most = 0.0;  ///< largest change, relative to the size
    bool to_the_end = true;
};

Kept kept(const Generated& generated, const general::Mechanics& reference, Way way, double tolerance) {
    way.settings.tolerance = tolerance;
    way.settings.most_steps = 5000;
    general::Mechanics mechanics = reference;
    const general::PlacedBodies before = mechanics.bodies_at(mechanics.start());
    const general::Model& model = mechanics.model();
    const Momentum start = momentum_of(model, before);
    const double L = generated.length;
    const double size = size_of_unit(model, before, L) * fastest(before, L);
    Simulation simulation(generated.mechanism, generated.loads, way.settings);
    Kept out;
    const auto outcome =
        simulation.run({0.0, 0.5 * kDuration, kDuration}, [&](double, const std::vector<double>& y) {
            const Momentum now = momentum_of(model, placed_of(simulation.scene(), y, before));
            const double change = difference_of(now, start, L) / size;
            if (!(change <= out.most)) { out.most = std::isfinite(change) ? change : HUGE_VAL; }
        });
    out.to_the_end = !outcome.failure;
    return out;
}

std::vector<Way> ways_of_momentum() {
    std::vector<Way> out = ways();
    for (const auto& [name, choice] :
         {std::pair("explicit-8 dense in (r, omega)", CoordinateChoice::omega_global),
          std::pair("explicit-8 dense in modified (r, p)", CoordinateChoice::modified_euler_parameters)}) {
        SimulationSettings dense;
        dense.dense = choice;
        out.push_back({name, dense});
    }
    return out;
}

}  // namespace

Recipe afloat(Recipe recipe) {
    recipe.afloat = true;
    return recipe;
}

Verdict momentum_stays(const Generated& generated) {
    if (!(generated.condition < 1e3)) { return not_asked("too near to a singular pose"); }
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    if (const Verdict verdict = rates_vanish(generated, reference); verdict.kind != Verdict::Kind::holds) {
        return verdict;
    }
    if (keeps_rows_by_hand(generated.mechanism)) { return holds(); }
    const general::Accelerations a = reference.accelerations_at(reference.start());
    // such a scene is stiff; others are checked over a whole run
    if (!(size_of(a, generated.length) < 300.0)) { return holds(); }
    for (const Way& way : ways_of_momentum()) {
        const Kept found = kept(generated, reference, way, 1e-9);
        // another property checks runs that end early
        if (!found.to_the_end || found.most <= kAllowed) { continue; }
        const Kept tighter = kept(generated, reference, way, 1e-11);
        if (!tighter.to_the_end || tighter.most <= kAllowed) { continue; }
        return fails(changes("momentum", way.name, found.most));
    }
    return holds();
}

}  // namespace jw::test
