#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "app/session/benchmark/benchmark.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/motion/time_events.hpp"

namespace jw {

namespace {

constexpr long kMostReferenceSteps = 1'000'000;
/// Largest residual after a projection if the parts fit, relative to the size of an equation; far above
/// rounding.
constexpr double kMetByReference = 1e-9;

/// Positions and velocities of the lesson's point at the times of a reference.
using PointPath = std::vector<std::pair<Vec3, Vec3>>;

/// One way to compute a reference: its description, and its path or why there is none.
struct ReferenceWay {
    std::string name;
    std::optional<PointPath> path;
    std::string failure;
};

/// Adds the place of the lesson's point in a flat state; ends the run if it is asked to stop.
void record_place(
    const Lesson& lesson, const Simulation& simulation, const std::vector<double>& y,
    const std::stop_token& stop, PointPath& path) {
    if (stop.stop_requested()) { throw Stopped(); }
    const BodyPoint& tracked = *lesson.dynamics->point;
    path.emplace_back(
        simulation.point(y, tracked.body, tracked.point_local),
        simulation.point_velocity(y, tracked.body, tracked.point_local));
}

using Numbers = std::vector<double>;

// 2, 6, 10 ... 26 small steps: these keep the weights of the extrapolation, and so its rounding, small
constexpr std::size_t kColumns = 7;
constexpr int steps_of(std::size_t column) { return static_cast<int>(4 * column + 2); }
constexpr double kOrder = 2.0 * kColumns;

/// Gragg's modified midpoint rule, extrapolated to a step of length 0. It shares no coefficients, step
/// control or sampling with the program's methods.
/// @source Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, II.9
class Extrapolation {
public:
    Extrapolation(MotionEquations& equations, double tolerance)
        : equations_(equations), tolerance_(tolerance), slope_(static_cast<std::size_t>(equations.size())) {}

    /// One step of length h. @return its error relative to the tolerance; not finite if the step failed
    double step(double t, double h, Numbers& y) {
        Numbers first(y.size());
        equations_.evaluate(t, y.data(), first.data());
        Numbers error(y.size());
        for (std::size_t k = 0; k < kColumns; ++k) {
            Numbers value = midpoint_rule(t, h, y, first, steps_of(k));
            for (std::size_t m = 1; m <= k; ++m) {
                const double ratio = static_cast<double>(steps_of(k)) / steps_of(k - m);
                for (std::size_t n = 0; n < y.size(); ++n) {
                    const double correction = (value[n] - row_[m - 1][n]) / (ratio * ratio - 1.0);
                    row_[m - 1][n] = value[n];
                    value[n] += correction;
                    error[n] = correction;
                }
            }
            row_[k] = std::move(value);
        }
        double largest = 0.0;
        for (std::size_t n = 0; n < y.size(); ++n) {
            const double by_size = std::abs(error[n]) / (1.0 + std::abs(y[n]));
            if (!(by_size <= largest)) { largest = by_size; }
            y[n] += row_[kColumns - 1][n];
        }
        return largest / tolerance_;
    }

private:
    /// Change of y over `count` midpoint steps (an even number). Changes are smaller than y, and so is the
    /// rounding error.
    Numbers midpoint_rule(double t, double h, const Numbers& y, const Numbers& first, int count) {
        const double small = h / count;
        Numbers before(y.size(), 0.0);
        Numbers now(y.size());
        Numbers there(y.size());
        for (std::size_t n = 0; n < y.size(); ++n) { now[n] = small * first[n]; }
        for (int s = 1; s < count; ++s) {
            for (std::size_t n = 0; n < y.size(); ++n) { there[n] = y[n] + now[n]; }
            equations_.evaluate(t + s * small, there.data(), slope_.data());
            for (std::size_t n = 0; n < y.size(); ++n) { before[n] += 2.0 * small * slope_[n]; }
            before.swap(now);
        }
        return now;
    }

    MotionEquations& equations_;
    double tolerance_;
    Numbers slope_;
    std::array<Numbers, kColumns> row_;
};

/// Integrates from times.front() to times.back(). A step ends at each of the times; y is projected after each
/// step.
/// @param tolerance of a step: the error of a number y is divided by 1 + |y|
/// @param receive given y at every time
/// @return false if no step is short enough, or `most_steps` are not enough
bool extrapolate(
    MotionEquations& equations, std::vector<double> y, const std::vector<double>& times, double tolerance,
    long most_steps, const std::function<void(const std::vector<double>& y)>& receive) {
    Extrapolation extrapolation(equations, tolerance);
    const double duration = times.back() - times.front();
    double h = 1e-3 * duration;
    long steps = 0;
    receive(y);
    for (std::size_t k = 1; k < times.size(); ++k) {
        double t = times[k - 1];
        while (t < times[k]) {
            if (++steps > most_steps || !(h > 1e-10 * duration)) { return false; }
            equations.choose_rows(t, y.data());
            const double left = times[k] - t;
            const bool last = h >= left;
            const double tried = last ? left : std::min(h, 0.5 * left);
            Numbers next = y;
            const double error = extrapolation.step(t, tried, next);
            const double finite = std::isfinite(error) ? std::max(error, 1e-20) : 1e20;
            const double factor = std::clamp(0.8 * elementary::pow(finite, -1.0 / (kOrder - 1.0)), 0.2, 4.0);
            if (finite > 1.0) {
                h = tried * factor;
                continue;
            }
            h = last ? std::max(h, tried * factor) : tried * factor;
            t = last ? times[k] : t + tried;
            y = std::move(next);
            equations.project(t, y.data());
        }
        receive(y);
    }
    return true;
}

/// Integrates the equations of the bodies as no method does. It does not count the turns of springs;
/// only runs of the program do.
ReferenceWay by_extrapolation(
    const Lesson& lesson, const std::vector<double>& times, const std::stop_token& stop) {
    constexpr double tolerance = 1e-13;
    ReferenceWay way{"block equations of the bodies, extrapolated midpoint rule at 1e-13", {}, {}};
    if (depends_on_turns(lesson.dynamics->loads)) {
        way.failure = "it does not count the turns of springs";
        return way;
    }
    SimulationSettings settings;
    settings.formulation = Formulation::bodies;
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    // steps end where a function of time starts or stops changing; these times are not samples
    std::vector<double> stops = times;
    for (const TimeEvent& event : events_until(times.back(), simulation.scene())) {
        stops.push_back(event.t);
    }
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    PointPath path;
    std::size_t stopped = 0;
    double violation = 0.0;
    const bool done = extrapolate(
        simulation.integrated(), simulation.integrated_start(), stops, tolerance, kMostReferenceSteps,
        [&](const std::vector<double>& y) {
            const double t = stops[stopped++];
            violation = std::max(violation, simulation.equations().violation(t, y.data()).first);
            if (std::ranges::binary_search(times, t)) { record_place(lesson, simulation, y, stop, path); }
        });
    if (!done) {
        way.failure = "no step is short enough for it";
    } else if (!(violation <= kMetByReference)) {
        way.failure = "it leaves the constraints by " + number_text(violation, 2);
    } else {
        way.path = std::move(path);
    }
    return way;
}

/// A run of the program, by equations that none of the compared methods uses where this is affordable.
ReferenceWay by_run(
    const Lesson& lesson, const SimulationSettings& asked, const std::string& name,
    const std::vector<double>& times, const std::stop_token& stop) {
    ReferenceWay way{name, {}, {}};
    SimulationSettings settings = asked;
    settings.tolerance = 1e-12;
    settings.most_steps = kMostReferenceSteps;
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    PointPath path;
    const SimulationOutcome outcome = simulation.run(times, [&](double, const std::vector<double>& y) {
        record_place(lesson, simulation, y, stop, path);
    });
    if (outcome.failure) {
        way.failure = "at tolerance 1e-12 " + failure_text(*outcome.failure, settings, lesson.mechanism);
    } else {
        way.path = std::move(path);
    }
    return way;
}

/// The dense equations of the slides; their cost grows with the cube of the number of bodies.
ReferenceWay by_slides(const Lesson& lesson, const std::vector<double>& times, const std::stop_token& stop) {
    constexpr int most_bodies = 20;
    SimulationSettings settings;
    if (lesson.mechanism.moving_bodies_count() <= most_bodies) {
        settings.dense = CoordinateChoice::true_euler_parameters;
        return by_run(lesson, settings, "dense equations in (r, p), explicit-8 at 1e-12", times, stop);
    }
    settings.formulation = Formulation::bodies;
    return by_run(lesson, settings, "block equations of the bodies, explicit-8 at 1e-12", times, stop);
}

double largest_distance(const PointPath& a, const PointPath& b) {
    double apart = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { apart = std::max(apart, (a[k].first - b[k].first).norm()); }
    return apart;
}

std::string agreement_text(const PointPath& best, const PointPath& check) {
    const double apart = largest_distance(best, check);
    double reach = 0.0;
    for (const auto& [position, velocity] : best) { reach = std::max(reach, position.norm()); }
    const double digits = std::floor(-elementary::log10(std::max(apart / std::max(reach, 1e-300), 1e-16)));
    return number_text(apart, 2) + " m apart: " + number_text(std::max(digits, 0.0), 2) +
           " digits agree; smaller errors have no meaning";
}

}  // namespace

Reference own_reference(const Lesson& lesson, const std::stop_token& stop) {
    Reference reference;
    reference.times = equal_times(lesson.dynamics->duration, 100);
    ReferenceWay first = by_extrapolation(lesson, reference.times, stop);
    ReferenceWay second = by_slides(lesson, reference.times, stop);
    if (!first.path && !second.path) {
        throw std::runtime_error("nothing to compare with: " + second.failure);
    }
    const bool both = first.path && second.path;
    const ReferenceWay& best = first.path ? first : second;
    const ReferenceWay& other = first.path ? second : first;
    for (const auto& [position, velocity] : *best.path) {
        reference.positions.push_back(position);
        reference.velocities.push_back(velocity);
    }
    reference.origin = best.name + " (none is stored), ";
    reference.origin += both ? "and " + other.name + ": " + agreement_text(*best.path, *other.path)
                             : "not checked in a second way: " + other.failure;
    return reference;
}

}  // namespace jw
