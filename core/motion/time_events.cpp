#include "core/motion/time_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jw {

namespace {

/// Calls `f` with every function of time that moves the scene.
template <class F>
void for_each_function(const Centroidal& scene, F&& f) {
    for (const Driver& driver : scene.mechanism.drivers) { f(driver.function); }
    for (const AppliedForce& force : scene.loads.forces) { f(force.magnitude); }
    for (const AppliedTorque& torque : scene.loads.torques) { f(torque.magnitude); }
}

}  // namespace

std::vector<double> events_until(double end, const Centroidal& scene) {
    std::vector<double> events;
    for_each_function(scene, [&](const TimeFunction& function) { function.append_kinks(events); });
    std::erase_if(events, [&](double t) { return t <= 0.0 || t >= end; });
    events.push_back(end);
    std::ranges::sort(events);
    const auto same = [&](double a, double b) { return b - a <= 1e-12 * end; };
    events.erase(std::unique(events.begin(), events.end(), same), events.end());
    events.back() = end;
    return events;
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
