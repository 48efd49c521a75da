#include "core/motion/time_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/motion/forces.hpp"

namespace jw {

namespace {

// times that are nearer to each other differ by rounding only
constexpr double kSameTime = 1e-12;

/// Calls `f` with every function of time that moves the scene.
template <class F>
void for_each_function(const Centroidal& scene, F&& f) {
    for (const Driver& driver : scene.mechanism.drivers) { f(driver.function); }
    for (const AppliedForce& force : scene.loads.forces) { f(force.magnitude); }
    for (const AppliedTorque& torque : scene.loads.torques) { f(torque.magnitude); }
}

/// True if the fourth derivative of a formula is bounded in every part of the time: then its swings can be
/// found.
bool has_bounded_swings(const TimeFormula& formula, double end) {
    constexpr int parts = 100;
    for (int k = 0; k < parts; ++k) {
        const double bound = formula.taylor_bounds(end * k / parts, end * (k + 1) / parts)[4];
        if (!std::isfinite(bound)) { return false; }
    }
    return true;
}

}  // namespace

std::vector<TimeEvent> events_until(double end, const Centroidal& scene) {
    std::vector<double> jumps;
    std::vector<double> swings;
    for_each_function(scene, [&](const TimeFunction& function) {
        function.append_kinks(jumps);
        if (function.formula) { function.formula->append_swings(0.0, end, swings); }
    });
    // laws change also with the motion, which steps follow by their error; what swings by itself does so at
    // the start pose, too
    for (ScalarFormula& law : laws_in_time(scene.loads, kinematics_of(start_state(scene.mechanism)))) {
        const TimeFormula formula{std::move(law)};
        if (has_bounded_swings(formula, end)) { formula.append_swings(0.0, end, swings); }
    }
    std::vector<TimeEvent> events;
    const auto add = [&](double t, bool is_jump) {
        if (t > 0.0 && t < end) { events.push_back({t, is_jump}); }
    };
    for (const double t : jumps) { add(t, true); }
    for (const double t : swings) { add(t, false); }
    // events at the same time become one, which jumps if any of them jumps
    std::ranges::stable_sort(events, {}, &TimeEvent::t);
    std::vector<TimeEvent> apart;
    for (const TimeEvent& event : events) {
        const bool is_same = !apart.empty() && event.t - apart.back().t <= kSameTime * end;
        if (is_same) { apart.back().jumps = apart.back().jumps || event.jumps; }
        if (!is_same) { apart.push_back(event); }
    }
    if (!apart.empty() && end - apart.back().t <= kSameTime * end) { apart.pop_back(); }
    apart.push_back({end, true});
    return apart;
}

double half_of_fastest_swing(const Centroidal& scene) {
    double omega = 0.0;
    for_each_function(scene, [&](const TimeFunction& function) {
        for (const TimeFunction::Harmonic& h : function.harmonics) {
            if (h.amplitude != 0.0) { omega = std::max(omega, std::abs(h.omega)); }
        }
    });
    return omega > 0.0 ? std::numbers::pi / omega : std::numeric_limits<double>::infinity();
}

}  // namespace jw
