#include "app/session/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "app/session/labels.hpp"
#include "app/session/quantities.hpp"
#include "app/session/series_parts.hpp"
#include "core/motion/forces.hpp"

namespace jw {

namespace {

// of the largest value of a unit: velocities and accelerations come from poses that are right to 1e-13
constexpr double kRoundingPart = 1e-10;
constexpr double kSmallestRounding = 1e-12;  // where everything of a unit is at rest

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Values are added moment after moment, in the same order at each.
class Columns {
public:
    explicit Columns(std::vector<Series>& series) : series_(&series) {}

    void begin_moment() { next_ = 0; }
    void add(const std::string& name, const char* unit, double value) {
        if (next_ == series_->size()) { series_->push_back({name, unit, {}, 0.0, false}); }
        (*series_)[next_++].values.push_back(value);
    }
    void add_vector(const std::string& name, const char* unit, const Vec3& v) {
        for (int k = 0; k < 3; ++k) { add(name + "." + axis_name(k), unit, v(k)); }
        add("|" + name + "|", unit, v.norm());
    }

private:
    std::vector<Series>* series_;
    std::size_t next_ = 0;
};

/// Angles come modulo a turn: takes the turn that is nearest to where the rates lead.
void unwrap(const std::vector<double>& t, Series& angle, const std::vector<double>& rate) {
    for (std::size_t k = 1; k < angle.values.size(); ++k) {
        const double expected = angle.values[k - 1] + 0.5 * (rate[k - 1] + rate[k]) * (t[k] - t[k - 1]);
        angle.values[k] = expected + std::remainder(angle.values[k] - expected, 360.0);
    }
}

void set_rounding(std::vector<Series>& series) {
    std::map<std::string, double> largest;
    for (const Series& s : series) {
        for (const double v : s.values) { largest[s.unit] = std::max(largest[s.unit], std::abs(v)); }
    }
    for (Series& s : series) { s.rounding = std::max(kSmallestRounding, kRoundingPart * largest[s.unit]); }
}

void add_quantities(const Step& step, Columns& columns) {
    for (const QuantityMotion& q : quantities_of(step)) {
        const std::string unit = q.unit == "-" ? "1" : q.unit;
        columns.add(q.name, q.unit.c_str(), q.value);
        columns.add(q.name + " rate", (unit + "/s").c_str(), q.rate);
        columns.add(q.name + " acceleration", (unit + "/s²").c_str(), q.acceleration);
    }
}

void add_bodies(const Step& step, Columns& columns) {
    for (const int body : step.system->moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        const std::string& name = step.system->mechanism().bodies[b].name;
        const Mat3 A = rotation_matrix(step.state.p[b]);
        columns.add_vector(name + ".r", "m", step.state.r[b]);
        columns.add_vector(name + ".r_dot", "m/s", step.velocity.r_dot[b]);
        columns.add_vector(name + ".r_ddot", "m/s²", step.acceleration.r_dot[b]);
        columns.add_vector(name + ".omega", "rad/s", A * step.velocity.omega_local[b]);
        columns.add_vector(name + ".omega_dot", "rad/s²", A * step.acceleration.omega_local[b]);
    }
}

void add_point(const Step& step, const BodyPoint& point, Columns& columns) {
    if (point.body < 0) { return; }
    const auto b = static_cast<std::size_t>(point.body);
    const std::string name = step.system->mechanism().bodies[b].name + ".point";
    const Mat3 A = rotation_matrix(step.state.p[b]);
    const Vec3 place = step.state.r[b] + A * point.point_local;
    const Vec3 speed = step.velocity.r_dot[b] + A * step.velocity.omega_local[b].cross(point.point_local);
    for (int k = 0; k < 3; ++k) { columns.add(name + "." + axis_name(k), "m", place(k)); }
    columns.add(name + " speed", "m/s", speed.norm());
}

/// Of a motion by masses and forces: their sum is level where nothing but gravity and springs acts.
/// @param scene  of the moments before: its rotational springs count their turns from one to the next
void add_energies(const Step& step, std::optional<Centroidal>& scene, Columns& columns) {
    if (!step.centroidal) { return; }
    if (!scene) { scene = *step.centroidal; }
    const State state = scene->to_centroidal(step.state);
    count_turns(scene->loads, kinematics_of(state));
    const Energy energy = energy_of(*scene, state, scene->to_centroidal(step.state, step.velocity));
    columns.add("energy.kinetic", "J", energy.kinetic);
    columns.add("energy.potential", "J", energy.potential);
    columns.add("energy.sum", "J", energy.kinetic + energy.potential);
}

/// How much a curve changes, in parts of its size: next to nothing for a motor that runs evenly.
double liveliness(const Series& series) {
    const auto [low, high] = std::ranges::minmax(series.values);
    const double size = std::max(std::abs(low), std::abs(high));
    return high - low > series.rounding ? (high - low) / size : 0.0;
}

/// A measure with its rates: of those that no driver prescribes the one whose rate changes most, since what
/// the others do is known; else the first. r of the first body where nothing is measured.
std::vector<int> telling_measure(const Story& story, const SeriesSet& set) {
    if (set.series.size() < 3) { return series::all_of(set); }
    const Step& step = story.steps()[static_cast<std::size_t>(set.steps.front())];
    int best = 0;
    double most = 0.0;
    int k = 0;
    for (const QuantityMotion& q : quantities_of(step)) {
        const double changes = q.driven ? 0.0 : liveliness(set.series[static_cast<std::size_t>(k) + 1]);
        if (changes > most) {
            most = changes;
            best = k;
        }
        k += 3;
    }
    return {best, best + 1, best + 2};
}

/// What happened in a solve, and the step that shows each event.
struct Solve {
    std::string name;
    std::vector<PositionEvent> events;
    std::vector<int> steps;
};

std::vector<Solve> solves_of(const Story& story) {
    std::vector<Solve> solves;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        const auto subject = subject_of(story.lesson(), step);
        if (!subject) { continue; }
        const Mechanism& mechanism = story.lesson().mechanism;
        const auto index = static_cast<std::size_t>(subject->index);
        if (step.kind == Step::Kind::equations) {
            const bool joint = subject->kind == Addition::Kind::joint;
            solves.push_back({joint ? mechanism.joints[index].name : mechanism.drivers[index].name, {}, {}});
            continue;
        }
        Solve& solve = solves.back();
        // closed, but at a wrong branch: seen in the step that leaves it; iterations that the story leaves
        // out: in the one before them
        while (solve.steps.size() + 1 < step.events.size()) {
            const std::size_t event = solve.steps.size();
            const auto is_newton = [&](std::size_t at) {
                return std::holds_alternative<NewtonStep>(step.events[at]);
            };
            // one that ends without a branch behind it gave up, and Newton began again elsewhere
            const bool closed = is_newton(event) && std::get<NewtonStep>(step.events[event]).rank == 0 &&
                                !is_newton(event + 1);
            const bool later = solve.steps.empty() || !is_newton(event) || closed;
            solve.steps.push_back(later ? static_cast<int>(k) : solve.steps.back());
        }
        solve.steps.resize(step.events.size(), static_cast<int>(k));
        solve.events = step.events;
    }
    return solves;
}

}  // namespace

SeriesSet motion_series(const Story& story, const BodyPoint& traced) {
    SeriesSet set = series::over_time(story);
    Columns columns(set.series);
    std::optional<Centroidal> scene;
    for (const int index : set.steps) {
        const Step& step = story.steps()[static_cast<std::size_t>(index)];
        columns.begin_moment();
        add_quantities(step, columns);
        add_point(step, traced, columns);
        add_bodies(step, columns);
        add_energies(step, scene, columns);
    }
    for (std::size_t k = 0; k + 1 < set.series.size(); ++k) {
        if (set.series[k].unit == "deg") { unwrap(set.at, set.series[k], set.series[k + 1].values); }
    }
    set_rounding(set.series);
    set.telling = telling_measure(story, set);
    return set;
}

SeriesSet newton_series(const Story& story) {
    SeriesSet set;
    set.axis = "iteration";
    set.logarithmic = true;
    for (const Solve& solve : solves_of(story)) {
        Series series{solve.name, "-", std::vector<double>(set.at.size(), kMissing), 0.0, false};
        for (std::size_t k = 0; k < solve.events.size(); ++k) {
            const auto* newton = std::get_if<NewtonStep>(&solve.events[k]);
            if (newton == nullptr) {
                if (!set.at.empty()) { set.marks.push_back({set.at.back(), "wrong branch left"}); }
                continue;
            }
            set.at.push_back(static_cast<double>(set.at.size()));
            set.steps.push_back(solve.steps[k]);
            series.values.push_back(newton->phi_norm);
        }
        if (!solve.events.empty()) { set.series.push_back(std::move(series)); }
    }
    for (Series& s : set.series) { s.values.resize(set.at.size(), kMissing); }
    set.telling = series::all_of(set);
    if (set.at.empty()) { set.why_empty = "No iterations here: the lesson adds neither joints nor drivers."; }
    return set;
}

}  // namespace jw
