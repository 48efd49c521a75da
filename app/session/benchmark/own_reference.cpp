#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/benchmark/benchmark.hpp"
#include "app/session/benchmark/extrapolation.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
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

/// Records the position of the point in the flat states that it receives; ends the run if it is asked to
/// stop.
class PointRecorder {
public:
    PointRecorder(const Lesson& lesson, const Simulation& simulation, const std::stop_token& stop)
        : tracked_(*lesson.dynamics->point), simulation_(simulation), stop_(stop) {}

    void operator()(const std::vector<double>& y) {
        if (stop_.stop_requested()) { throw Stopped(); }
        path.emplace_back(
            simulation_.point(y, tracked_.body, tracked_.point_local),
            simulation_.point_velocity(y, tracked_.body, tracked_.point_local));
    }

    PointPath path;

private:
    const BodyPoint& tracked_;
    const Simulation& simulation_;
    const std::stop_token& stop_;
};

/// The equations of the bodies by an integrator that no method uses. It does not count the turns of springs;
/// only runs of the program do.
ReferenceWay by_extrapolation(
    const Lesson& lesson, const std::vector<double>& times, const std::stop_token& stop) {
    constexpr double tolerance = 1e-13;
    ReferenceWay way{"block equations of the bodies, extrapolated midpoint rule at 1e-13", {}, {}};
    const auto turns = [](const RotationalSpring& spring) { return spring.depends_on_angle(); };
    if (std::ranges::any_of(lesson.dynamics->loads.rotational_springs, turns)) {
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
    PointRecorder record(lesson, simulation, stop);
    std::size_t stopped = 0;
    double violation = 0.0;
    const bool done = extrapolate(
        simulation.integrated(), simulation.integrated_start(), stops, tolerance, kMostReferenceSteps,
        [&](const std::vector<double>& y) {
            const double t = stops[stopped++];
            violation = std::max(violation, simulation.equations().violation(t, y.data()).first);
            if (std::ranges::binary_search(times, t)) { record(y); }
        });
    if (!done) {
        way.failure = "no step is short enough for it";
    } else if (!(violation <= kMetByReference)) {
        way.failure = "it leaves the constraints by " + number_text(violation, 2);
    } else {
        way.path = std::move(record.path);
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
    PointRecorder record(lesson, simulation, stop);
    const SimulationOutcome outcome =
        simulation.run(times, [&](double, const std::vector<double>& y) { record(y); });
    if (outcome.failure) {
        way.failure = "at tolerance 1e-12 " + failure_text(*outcome.failure, settings, lesson.mechanism);
    } else {
        way.path = std::move(record.path);
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
