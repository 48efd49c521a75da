#include <algorithm>
#include <cstdio>

#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/soak/ways.hpp"
#include "tests/support/generators/to_model.hpp"

namespace jw::test {

namespace {

namespace general = reference::general;

constexpr double kDuration = 0.3;
constexpr int kSamples = 24;
// of the reference in long double: its own error is a thousandth of the tolerance of core
constexpr long double kReferenceTolerance = 1e-12L;
// global errors of a run with tolerance 1e-9: a hundred steps, and what the motion multiplies in 0.3 s
constexpr double kAllowed = 1e-6;

/// Times of the samples, so many that a singular pose passed between two of them shows.
std::vector<double> samples() {
    std::vector<double> times;
    for (int k = 0; k <= kSamples; ++k) { times.push_back(kDuration * k / kSamples); }
    return times;
}

struct Expected {
    std::vector<general::PlacedBodies> at;
    std::string refused;  ///< why there is no trustworthy motion
};

Expected expected_of(const Generated& generated, const std::vector<double>& times) {
    general::Mechanics mechanics(model_of(generated.mechanism, generated.loads));
    Expected out;
    const auto receive = [&](const reference::VecX& y) {
        out.at.push_back(mechanics.bodies_at(y));
        const general::Accelerations a = mechanics.accelerations_at(y);
        // beyond a singular pose the reference may follow another branch
        const double most = std::max(100.0, 10.0 * generated.condition);
        if (!(a.condition < most) || a.rank != generated.rank) {
            out.refused = "it comes near to a singular pose";
        }
        // such a scene is stiff, or moves too far in 0.3 s for tolerances to mean anything
        if (!(size_of(a, generated.length) < 1e3)) { out.refused = "it moves too fast"; }
    };
    try {
        reference::integrate(
            mechanics, std::vector<reference::Real>(times.begin(), times.end()),
            reference::Method::runge_kutta_fehlberg, kReferenceTolerance, receive, 400);
    } catch (const std::runtime_error&) { out.refused = "the reference takes too many steps"; }
    return out;
}

/// Largest distance of origins, in units of the scene, and of columns of A; negative where the run ended
/// early.
struct Apart {
    double most = 0.0;
    std::string ended;
};

Apart apart(
    const Generated& generated, const Expected& expected, const std::vector<double>& times, Way way,
    double tolerance) {
    way.settings.tolerance = tolerance;
    way.settings.most_steps = 20000;
    Simulation simulation(generated.mechanism, generated.loads, way.settings);
    Apart out;
    std::size_t k = 0;
    const auto outcome = simulation.run(times, [&](double, const std::vector<double>& y) {
        const general::PlacedBodies& reference = expected.at[k++];
        const general::PlacedBodies found = placed_of(simulation.scene(), y, reference);
        for (std::size_t b = 0; b < found.size(); ++b) {
            const auto way_off = static_cast<double>((found[b].c - reference[b].c).norm()) / generated.length;
            const auto turned = static_cast<double>((found[b].A - reference[b].A).norm());
            if (!(std::max(way_off, turned) <= out.most)) {
                out.most = std::isfinite(way_off + turned) ? std::max(way_off, turned) : HUGE_VAL;
            }
        }
    });
    if (outcome.failure) {
        out.ended = " ends at " + std::to_string(outcome.failure->t) + " s, cause " +
                    std::to_string(static_cast<int>(outcome.failure->cause)) + " " +
                    outcome.failure->equation_of;
    }
    return out;
}

}  // namespace

Verdict methods_converge(const Generated& generated) {
    if (!(generated.condition < 1e3)) { return not_asked("it begins near a singular pose"); }
    if (keeps_rows_by_hand(generated.mechanism)) {
        return not_asked("two rows that are kept by hand may lose their rank on the way");
    }
    const std::vector<double> times = with_events(generated, samples());
    const Expected expected = expected_of(generated, times);
    if (!expected.refused.empty()) { return not_asked(expected.refused); }
    for (const Way& way : ways()) {
        Apart found = apart(generated, expected, times, way, 1e-9);
        if (found.ended.empty() && found.most <= kAllowed) { continue; }
        // an error that vanishes at a tighter tolerance is not a fault
        const Apart tighter = apart(generated, expected, times, way, 1e-11);
        if (tighter.ended.empty() && tighter.most <= kAllowed) { continue; }
        char text[200];
        std::snprintf(
            text, sizeof text, "is %.2g of the scene off at tolerance 1e-9, %.2g at 1e-11;", found.most,
            tighter.most);
        return fails(way.name + ' ' + text + found.ended + tighter.ended);
    }
    return holds();
}

}  // namespace jw::test
