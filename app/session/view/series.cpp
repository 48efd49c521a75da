#include "app/session/view/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "app/session/view/quantities.hpp"
#include "app/session/view/series_parts.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "core/motion/forces.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

// relative to the largest value of a unit: velocities and accelerations come from poses that are accurate to
// 1e-13
constexpr double kRoundingPart = 1e-10;
constexpr double kSmallestRounding = 1e-12;  // where everything of a unit is at rest

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

void set_rounding(std::vector<Series>& series) {
    std::map<std::string, double> largest;
    for (const Series& s : series) {
        for (const double v : s.values) { largest[s.unit] = std::max(largest[s.unit], std::abs(v)); }
    }
    for (Series& s : series) { s.rounding = std::max(kSmallestRounding, kRoundingPart * largest[s.unit]); }
}

/// Adds the step's own measures, each followed by its rate and acceleration.
void add_measures(const Step& step, std::vector<Series>& series) {
    const bool first = series.empty();
    std::size_t next = 0;
    const auto add = [&](const std::string& name, const std::string& unit, double value) {
        if (first) { series.push_back({name, unit, {}, 0.0, false}); }
        series[next++].values.push_back(value);
    };
    for (const QuantityMotion& q : quantities_of(step)) {
        const std::string unit = q.unit == "-" ? "1" : q.unit;
        add(q.name, q.unit, q.value);
        add(q.rate_name, unit + "/s", q.rate);
        add(q.acceleration_name, unit + "/s²", q.acceleration);
    }
}

/// Lists r, ṙ, r̈, ω, ω̇ of a body, each with its magnitude.
void list_vectors(int body, std::vector<NamedQuantity>& list) {
    const auto add_size = [&](BodyVector vector) { list.push_back({BodySizeQuantity{body, vector}, 0}); };
    constexpr std::array places{BodyVector::r, BodyVector::r_dot, BodyVector::r_ddot};
    for (int derivative = 0; derivative < 3; ++derivative) {
        for (int k = 0; k < 3; ++k) {
            list.push_back({MeasureQuantity{CoordinateMeasure{k}, 0, body, -1, -1}, derivative});
        }
        add_size(places[at(derivative)]);
    }
    for (int derivative = 0; derivative < 2; ++derivative) {
        for (int k = 0; k < 3; ++k) { list.push_back({AngularVelocityQuantity{body, false, k}, derivative}); }
        add_size(derivative == 0 ? BodyVector::omega : BodyVector::omega_dot);
    }
}

/// Lists the quantities plotted beside the measures of drivers and joints. In a motion by masses and forces
/// these include the energies: their sum is constant where only gravity and springs act.
std::vector<NamedQuantity> further_quantities(const Step& step, const BodyPoint& traced) {
    std::vector<NamedQuantity> list;
    if (traced.body >= 0) {
        for (int k = 0; k < 3; ++k) {
            list.push_back({PointQuantity{traced.body, traced.point_local, k}, 0});
        }
        list.push_back({PointSpeedQuantity{traced.body, traced.point_local}, 0});
    }
    for (const int body : step.system->moving_bodies()) { list_vectors(body, list); }
    if (!step.centroidal) { return list; }
    for (int k = 0; k < kEnergyParts; ++k) {
        list.push_back({EnergyQuantity{static_cast<EnergyPart>(k)}, 0});
    }
    return list;
}

const Step& moment_at(const Story& story, const SeriesSet& set, std::size_t point) {
    if (set.of_curve) { return story.curve()[point]; }
    return story.steps()[at(set.steps[point])];
}

/// Relative change of a curve: almost zero for a driver that moves evenly.
double liveliness(const Series& series) {
    const auto [low, high] = std::ranges::minmax(series.values);
    const double size = std::max(std::abs(low), std::abs(high));
    return high - low > series.rounding ? (high - low) / size : 0.0;
}

/// Indices of the measure to show first and of its rates: of those that no driver prescribes (the others are
/// known), the one whose rate changes most; else the first. If nothing is measured, r of the first body.
std::vector<int> telling_measure(const Story& story, const SeriesSet& set) {
    if (set.series.size() < 3) { return series::all_of(set); }
    const Step& step = story.steps()[at(set.steps.front())];
    int best = 0;
    double most = 0.0;
    int k = 0;
    for (const QuantityMotion& q : quantities_of(step)) {
        const double changes = q.driven ? 0.0 : liveliness(set.series[at(k) + 1]);
        // if only rounding distinguishes curves, the first is taken
        if (changes > (1.0 + 1e-9) * most) {
            most = changes;
            best = k;
        }
        k += 3;
    }
    return {best, best + 1, best + 2};
}

/// Events of a Newton solve, and the step that shows each of them.
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
        // a question and its answer show the pose of another step, without the events that led there
        if (!subject || is_asked(step.kind)) { continue; }
        if (step.kind == Step::Kind::equations) {
            solves.push_back({name_of(*subject, story.lesson().mechanism), {}, {}});
            continue;
        }
        Solve& solve = solves.back();
        // an iteration that closes on a wrong branch is shown by the step that leaves it; iterations that the
        // story leaves out, by the step before them
        while (solve.steps.size() + 1 < step.events.size()) {
            const std::size_t event = solve.steps.size();
            const auto is_newton = [&](std::size_t at) {
                return std::holds_alternative<NewtonStep>(step.events[at]);
            };
            // where a solve ends and no wrong branch follows, it gave up, and Newton began again elsewhere
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

int add_series(SeriesSet& set, const Story& story, const std::vector<NamedQuantity>& list) {
    const Mechanism& mechanism = story.lesson().mechanism;
    std::vector<NamedQuantity> wanted;
    const std::size_t first = set.series.size();
    for (const NamedQuantity& named : list) {
        const std::string name = name_of(named.quantity, named.derivative, mechanism);
        if (std::ranges::find(set.series, name, &Series::name) != set.series.end()) { continue; }
        wanted.push_back(named);
        set.series.push_back({name, unit_text(named.quantity, named.derivative), {}, 0.0, false});
    }
    for (std::size_t point = 0; point < set.at.size() && !wanted.empty(); ++point) {
        const Instant instant = instant_of(moment_at(story, set, point));
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const QuantityValue v = evaluate(wanted[k].quantity, instant, wanted[k].derivative);
            const double number = v.derivatives[at(wanted[k].derivative)];
            set.series[first + k].values.push_back(factor_of_unit(wanted[k].quantity) * number);
        }
    }
    set_rounding(set.series);
    return static_cast<int>(wanted.size());
}

SeriesSet motion_series(const Story& story, const BodyPoint& traced) {
    SeriesSet set = series::over_curve(story);
    if (set.at.empty()) { return set; }
    for (std::size_t point = 0; point < set.at.size(); ++point) {
        add_measures(moment_at(story, set, point), set.series);
    }
    add_series(set, story, further_quantities(moment_at(story, set, 0), traced));
    set.telling = telling_measure(story, set);
    return set;
}

SeriesSet newton_series(const Story& story) {
    SeriesSet set;
    set.axis = tr_later("iteration");
    set.logarithmic = true;
    for (const Solve& solve : solves_of(story)) {
        Series series{solve.name, "-", std::vector<double>(set.at.size(), kMissing), 0.0, false};
        for (std::size_t k = 0; k < solve.events.size(); ++k) {
            std::visit(
                Overloaded{
                    [&](const NewtonStep& newton) {
                        set.at.push_back(static_cast<double>(set.at.size()));
                        set.steps.push_back(solve.steps[k]);
                        series.values.push_back(newton.phi_norm);
                    },
                    [&](const WrongBranch&) {
                        if (!set.at.empty()) {
                            set.marks.push_back({set.at.back(), tr("left the wrong branch")});
                        }
                    },
                },
                solve.events[k]);
        }
        if (!solve.events.empty()) { set.series.push_back(std::move(series)); }
    }
    for (Series& s : set.series) { s.values.resize(set.at.size(), kMissing); }
    set.telling = series::all_of(set);
    if (set.at.empty()) {
        set.why_empty = tr("No iterations here: the lesson adds neither joints nor drivers.");
    }
    return set;
}

}  // namespace jw
