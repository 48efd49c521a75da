#include "app/session/benchmark/benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "lessons/files/catalogue.hpp"

namespace jw {

namespace {

/// CPU time of a run beyond which its method's sweep ends [s].
constexpr double kTooLong = 5.0;
constexpr long kMostSteps = 4'000'000;  // the finest fixed step of a sweep takes 3.3 million

// a time of this many ticks of the clock is measured to 5 %
constexpr double kGrains = 20.0;

/// Processor time of this thread [s], so that a window running at the same time does not count.
double cpu_seconds() {
    timespec now{};
    // a browser does not report processor time; the copy of the page that measures does nothing else
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) { clock_gettime(CLOCK_MONOTONIC, &now); }
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Smallest step of the clock that was observed [s]: 1e-7 here, up to 1e-3 in a browser.
double grain_of_clock() {
    static const double grain = [] {
        double least = 1.0;
        for (int k = 0; k < 3; ++k) {
            const double before = cpu_seconds();
            double after = before;
            while (after == before) { after = cpu_seconds(); }
            least = std::min(least, after - before);
        }
        return least;
    }();
    return grain;
}

/// True if energy is conserved: only gravity and springs act.
bool keeps_energy(const Lesson& lesson) {
    const Loads& loads = lesson.dynamics->loads;
    const auto damped = [](const auto& spring) {
        return spring.damping != 0.0 || spring.friction.size != 0.0 || spring.law;
    };
    return loads.forces.empty() && loads.torques.empty() && std::ranges::none_of(loads.springs, damped) &&
           loads.rotational_springs.empty() && loads.bushings.empty() && lesson.mechanism.drivers.empty();
}

/// True if the last four settings have not halved an error below 1e-8: more steps do not help any more.
bool stands_still(const std::vector<BenchPoint>& points) {
    constexpr std::size_t looked_back = 4;
    if (points.size() <= looked_back) { return false; }
    const double before = points[points.size() - 1 - looked_back].position;
    return before < 1e-8 && points.back().position > 0.5 * before;
}

std::vector<double> settings_of(Method method, double duration) {
    std::vector<double> settings;
    if (entry_of(method).adaptive) {
        for (int k = 3; k <= 26; ++k) { settings.push_back(elementary::pow(10.0, -0.5 * k)); }
    } else {
        for (int k = 2; k <= 6; ++k) {
            for (const double part : {1.0, 0.3}) {
                settings.push_back(duration * part * elementary::pow(10.0, -k));
            }
        }
    }
    return settings;
}

/// States of a run at the reference's times; errors are computed after the clock has stopped.
struct Recorded {
    std::vector<std::vector<double>> states;
    SimulationOutcome outcome;
    double cpu = 0.0;
};

Recorded record(
    const Lesson& lesson, const SimulationSettings& settings, const std::vector<double>& times,
    const std::stop_token& stop) {
    Recorded recorded;
    recorded.states.reserve(times.size());
    const double start = cpu_seconds();
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    recorded.outcome = simulation.run(times, [&](double, const std::vector<double>& y) {
        if (stop.stop_requested()) { throw Stopped(); }
        recorded.states.push_back(y);
    });
    recorded.cpu = cpu_seconds() - start;
    return recorded;
}

void measure(const Lesson& lesson, const Reference& reference, const Recorded& recorded, BenchPoint& point) {
    TrajectoryErrors errors(lesson, reference);
    for (std::size_t k = 0; k < recorded.states.size(); ++k) { errors.look_at(k, recorded.states[k]); }
    point.position = errors.position();
    point.velocity = reference.velocities.empty() ? kNotKnown : errors.velocity();
    point.energy = keeps_energy(lesson) ? errors.energy() : kNotKnown;
    point.violation = errors.violation();
}

BenchPoint bench_point(
    const Lesson& lesson, const SimulationSettings& settings, const Reference& reference, double least_time,
    const std::stop_token& stop) {
    BenchPoint point;
    point.setting = settings.tolerance;
    const Recorded first = record(lesson, settings, reference.times, stop);
    point.counts = first.outcome.counts;
    // shorter runs are repeated and measured together
    const double shortest = kGrains * grain_of_clock();
    if (first.cpu >= shortest) { point.cpu = first.cpu; }
    for (double spent = first.cpu; spent < least_time || !(point.cpu > 0.0);) {
        double several = 0.0;
        int count = 0;
        do {
            several += record(lesson, settings, reference.times, stop).cpu;
            ++count;
        } while (several < shortest);
        const double each = several / count;
        point.cpu = point.cpu > 0.0 ? std::min(point.cpu, each) : each;
        spent += several;
    }
    if (first.outcome.failure) {
        point.failure = failure_text(*first.outcome.failure, settings, lesson.mechanism);
        point.position = point.velocity = point.energy = point.violation = kNotKnown;
        return point;
    }
    measure(lesson, reference, first, point);
    return point;
}

/// Distance of two points [m]; infinite if one of them has a NaN.
double distance(const Vec3& a, const Vec3& b) {
    const double d = (a - b).norm();
    return std::isfinite(d) ? d : std::numeric_limits<double>::infinity();
}

}  // namespace

TrajectoryErrors::TrajectoryErrors(const Lesson& lesson, const Reference& reference)
    : reference_(&reference),
      tracked_(&*lesson.dynamics->point),
      simulation_(lesson.mechanism, lesson.dynamics->loads, {}) {}

void TrajectoryErrors::look_at(std::size_t k, const std::vector<double>& y) {
    const Vec3 r = simulation_.point(y, tracked_->body, tracked_->point_local);
    position_ = std::max(position_, distance(r, reference_->positions[k]));
    if (!reference_->velocities.empty()) {
        const Vec3 r_dot = simulation_.point_velocity(y, tracked_->body, tracked_->point_local);
        velocity_ = std::max(velocity_, distance(r_dot, reference_->velocities[k]));
    }
    MotionEquations& equations = simulation_.equations();
    violation_ = std::max(violation_, equations.violation(reference_->times[k], y.data()).first);
    const Energy energy = simulation_.energy(y);
    const double sum = energy.kinetic + energy.potential;
    if (k == 0) { energy_at_start_ = sum; }
    largest_kinetic_ = std::max(largest_kinetic_, energy.kinetic);
    change_ = std::max(change_, std::abs(sum - energy_at_start_));
}

std::optional<Reference> stored_reference(const std::filesystem::path& lesson_file) {
    namespace fs = std::filesystem;
    const fs::path shipped = fs::weakly_canonical(catalogue_folder()).parent_path();
    const fs::path inside = fs::weakly_canonical(lesson_file).lexically_relative(shipped);
    if (inside.empty() || *inside.begin() == "..") { return std::nullopt; }
    const fs::path path = shipped / "reference" / (lesson_file.stem().string() + ".csv");
    std::ifstream file(path);
    if (!file) { return std::nullopt; }
    Reference reference;
    std::string line;
    std::getline(file, line);
    reference.origin = line.starts_with("# ") ? line.substr(2) : line;
    std::getline(file, line);  // names of the columns
    while (std::getline(file, line)) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream numbers(line);
        double t = 0.0;
        Vec3 r;
        Vec3 v;
        if (!(numbers >> t >> r.x() >> r.y() >> r.z() >> v.x() >> v.y() >> v.z())) {
            throw std::runtime_error(path.string() + ": expected seven numbers in every row");
        }
        reference.times.push_back(t);
        reference.positions.push_back(r);
        reference.velocities.push_back(v);
    }
    return reference;
}

std::optional<double> BenchRun::time_to(double error) const {
    std::optional<double> least;
    for (const BenchPoint& point : points) {
        if (!(point.position <= error)) { continue; }
        least = std::min(least.value_or(point.cpu), point.cpu);
    }
    return least;
}

std::vector<BenchRun> bench_dynamics(
    const Lesson& lesson, const Reference& reference, const BenchPlan& plan, const BenchWatch& watch) {
    std::vector<BenchRun> runs;
    std::vector<Method> methods = plan.methods;
    if (methods.empty()) {
        methods = {Method::explicit_5, Method::explicit_8};
        if (plan.treatment == Treatment::projection) {
            methods.insert(methods.end(), {Method::implicit_5, Method::implicit_9});
        }
    }
    for (const Method method : methods) {
        BenchRun& run = runs.emplace_back();
        run.scene = lesson.title;
        run.method = method;
        run.treatment = plan.treatment;
        for (const double setting : settings_of(method, lesson.dynamics->duration)) {
            SimulationSettings settings;
            settings.method = method;
            settings.treatment = plan.treatment;
            settings.formulation = plan.formulation;
            settings.tolerance = settings.step = setting;
            settings.most_steps = kMostSteps;
            run.points.push_back(bench_point(lesson, settings, reference, plan.least_time, watch.stop));
            watch.seen(runs);
            // tighter settings take even longer, and once rounding is reached they are not more accurate
            if (run.points.back().cpu > kTooLong || stands_still(run.points)) { break; }
        }
    }
    return runs;
}

}  // namespace jw
