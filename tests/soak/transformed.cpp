#include <cstdio>

#include "core/poses/rank.hpp"
#include "tests/soak/changed.hpp"
#include "tests/soak/forms.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/soak/ways.hpp"
#include "tests/support/generators/to_model.hpp"

/// A mechanism that is moved, mirrored or rescaled has the same motion, moved, mirrored or rescaled.
namespace jw::test {

namespace {

namespace general = reference::general;

/// Change of a generated mechanism: each kind of change or not, as the seed says.
Change change_of(const Generated& generated) {
    Random random(static_cast<unsigned>(generated.recipe.seed) * 49979687U + 29U);
    const auto maybe = [&] { return random.number() < 0.0; };
    Change change;
    const bool turned = maybe() && !knows_directions(generated.mechanism);
    const Vec4 p = random.unit_p();
    const Vec3 shift = random.vector(generated.length);
    change.mirrored = maybe();
    // other sizes, other masses, and slow motion
    if (maybe()) { change.length = std::pow(10.0, random.number(-2.0, 2.0)); }
    if (maybe()) { change.mass = std::pow(10.0, random.number(-3.0, 3.0)); }
    if (maybe()) { change.time = std::pow(10.0, random.number(-1.0, 1.0)); }
    if (turned) {
        change.p = p;
        change.shift = change.length * shift;
    }
    return change;
}

std::string text_of(const Change& change) {
    char text[200];
    std::snprintf(
        text, sizeof text, " (%s%slength times %.3g, mass times %.3g, time times %.3g)",
        change.p == Vec4::Unit(0) ? "" : "turned, ", change.mirrored ? "mirrored, " : "", change.length,
        change.mass, change.time);
    return text;
}

Motion changed(const Motion& accelerations, const Change& change) {
    Motion out = accelerations;
    const double rate = 1.0 / (change.time * change.time);
    for (Vec3& v : out.r_dot) { v = change.length * rate * change.global(v); }
    for (Vec3& v : out.omega_local) { v = rate * change.local_turning(v); }
    return out;
}

}  // namespace

Verdict answers_transform(const Generated& generated) {
    if (!(generated.condition < 1e3)) { return not_asked("too near to a singular pose"); }
    const Change change = change_of(generated);
    const Generated other = changed(generated, change);
    const int rank = rank_of(generated.mechanism).rank;
    const int other_rank = rank_of(other.mechanism).rank;
    if (rank != other_rank) {
        return fails(
            "rank " + std::to_string(rank) + " becomes " + std::to_string(other_rank) + text_of(change));
    }
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    const general::Accelerations a = reference.accelerations_at(reference.start());
    const double size = size_of(a, generated.length) / (change.time * change.time);
    // accelerations.cpp checks the number of digits; a term that depends on a direction or on a unit is off
    // by its own size
    const auto c = static_cast<double>(a.condition);
    const double limit = 1e-5 + 1e-10 * c * c;
    const auto before = accelerations_in_all_forms(centroidal(generated.mechanism, generated.loads));
    const auto after = accelerations_in_all_forms(centroidal(other.mechanism, other.loads));
    for (std::size_t k = 0; k < before.size(); ++k) {
        const Motion expected = changed(before[k].accelerations, change);
        const double off = difference_of(after[k].accelerations, expected, other.length) / size;
        if (off <= limit) { continue; }
        char text[100];
        std::snprintf(text, sizeof text, "accelerations are another by %.2g of their size: ", off);
        return fails(text + before[k].name + text_of(change));
    }
    return holds();
}

namespace {

constexpr double kDuration = 0.1;
// there and back: two runs with tolerance 1e-9, see methods.cpp
constexpr double kAllowed = 2e-6;

/// End of a run, in the frames of the author.
std::optional<Snapshot> end_of(const Generated& generated, const Way& way) {
    Simulation simulation(generated.mechanism, generated.loads, way.settings);
    Snapshot end;
    const auto outcome = simulation.run(
        {0.0, kDuration}, [&](double t, const std::vector<double>& y) { end = simulation.snapshot(t, y); });
    if (outcome.failure) { return std::nullopt; }
    return end;
}

/// Starts the mechanism at the end of a run, with the opposite velocities.
void begin_at(Mechanism& mechanism, const Snapshot& snapshot) {
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        Body& body = mechanism.bodies[b];
        if (body.fixed) { continue; }
        body.r = snapshot.state.r[b];
        body.p = snapshot.state.p[b];
        body.r_dot = -snapshot.velocity.r_dot[b];
        body.omega_local = -snapshot.velocity.omega_local[b];
    }
    const std::vector<int> thetas = mechanism.theta_indices();
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        if (thetas[k] < 0) { continue; }
        JointGeometry& g = mechanism.joints[k].geometry;
        g.theta_start = snapshot.state.theta[at(thetas[k])];
        g.theta_dot_start = -snapshot.velocity.theta_dot[at(thetas[k])];
    }
}

/// Difference of the poses and of the opposite velocities, the latter relative to the fastest.
double difference_back(const Mechanism& start, const Snapshot& back, double length) {
    double most = 0.0;
    double fastest = 1.0;
    for (const Body& body : start.bodies) {
        fastest = std::max({fastest, body.r_dot.norm() / length, body.omega_local.norm()});
    }
    for (std::size_t b = 0; b < start.bodies.size(); ++b) {
        const Body& body = start.bodies[b];
        if (body.fixed) { continue; }
        const double way = (back.state.r[b] - body.r).norm() / length;
        const double turn = (reference::rotation(back.state.p[b].cast<long double>()) -
                             reference::rotation(body.p.cast<long double>()))
                                .cast<double>()
                                .norm();
        const double speed = (back.velocity.r_dot[b] + body.r_dot).norm() / length;
        const double spin = (back.velocity.omega_local[b] + body.omega_local).norm();
        const double here = std::max({way, turn, speed / fastest, spin / fastest});
        if (!(here <= most)) { most = std::isfinite(here) ? here : HUGE_VAL; }
    }
    return most;
}

/// Reason why a motion from here on cannot be judged; empty if it can.
std::string why_not(const Generated& generated) {
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    const general::Accelerations a = reference.accelerations_at(reference.start());
    if (!(a.condition < 1e3L) || a.rank != generated.rank) { return "near a singular pose"; }
    return size_of(a, generated.length) < 300.0 ? "" : "it moves too fast";
}

/// True if a spring is wound by more than half a turn on the way: a start from there would lose its turns.
bool winds_springs(const Generated& there, const Generated& back) {
    const auto angles = [](const Generated& g) {
        general::Mechanics mechanics(model_of(g.mechanism, g.loads));
        std::vector<long double> out;
        for (const general::TurningSpring& s : mechanics.model().turning_springs) {
            const auto value = general::angle_value(s.angle, mechanics.bodies_at(mechanics.start())).value;
            out.push_back(std::remainder(value - s.free_angle, 2.0L * reference::kPi));
        }
        return out;
    };
    const auto before = angles(there);
    const auto after = angles(back);
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (std::abs(before[k] - after[k]) > reference::kPi) { return true; }
    }
    return false;
}

/// Distance by which the motion played backwards misses its start; nothing where a run has no result.
std::optional<double> misses(const Generated& generated, Way way, double tolerance) {
    way.settings.tolerance = tolerance;
    way.settings.most_steps = 5000;
    const std::optional<Snapshot> there = end_of(generated, way);
    if (!there) { return std::nullopt; }
    Generated back = played_backwards(generated, kDuration);
    begin_at(back.mechanism, *there);
    if (!why_not(back).empty() || winds_springs(generated, back)) { return std::nullopt; }
    const std::optional<Snapshot> end = end_of(back, way);
    if (!end) { return std::nullopt; }
    return difference_back(generated.mechanism, *end, generated.length);
}

}  // namespace

Verdict comes_back(const Generated& generated) {
    const std::string refused = why_not(generated);
    if (!refused.empty()) { return not_asked(refused); }
    bool asked = false;
    for (const Way& way : ways()) {
        const std::optional<double> off = misses(generated, way, 1e-9);
        asked = asked || off;
        // another property checks runs that end early
        if (!off || *off <= kAllowed) { continue; }
        const std::optional<double> tighter = misses(generated, way, 1e-11);
        if (!tighter || *tighter <= kAllowed) { continue; }
        char text[160];
        std::snprintf(
            text, sizeof text, "there and back %s ends %.2g of the scene beside its start, %.2g at 1e-11",
            way.name.c_str(), *off, *tighter);
        return fails(text);
    }
    return asked ? holds() : not_asked("singular or too fast on the way");
}

}  // namespace jw::test
