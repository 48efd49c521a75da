#include "tests/bench/peers/counted_equations.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/singular_steps.hpp"

namespace jw::peers {

namespace {

/// Limits of our own explicit methods.
constexpr double kDriftShare = 0.1;
constexpr double kRowsTurnBad = 1e-2;
/// κ, as α of Baumgarte's stabilisation [1/s].
constexpr double kComesBack = 20.0;
/// Order of the step in which a scene at rest reaches the speed that errors are first compared with.
constexpr int kOrderOfFirstStep = 8;

SimulationSettings settings_of(double tolerance) {
    SimulationSettings settings;
    settings.method = Method::explicit_8;
    settings.tolerance = std::clamp(tolerance, kLeastTolerance, kMostTolerance);
    return settings;
}

IntegrationOptions options_of(const Lesson& lesson, double tolerance) {
    IntegrationOptions options;
    options.tolerance = tolerance;
    options.length_scale = extent(lesson.mechanism);
    options.duration = lesson.dynamics->duration;
    return options;
}

}  // namespace

CountedEquations::CountedEquations(const Lesson& lesson, double tolerance, Held held)
    : simulation_(lesson.mechanism, lesson.dynamics->loads, settings_of(tolerance)),
      tolerance_(tolerance),
      held_(held),
      start_(simulation_.integrated_start()),
      scales_(options_of(lesson, tolerance), equations().scales()) {
    equations().begin_turns(0.0, start_.data());
    equations().choose_rows(0.0, start_.data());
    if (has_loops()) { project(0.0, start_.data()); }
    first_rates_.resize(start_.size());
    evaluate(0.0, start_.data(), first_rates_.data());
    pivot_at_choice_ = regular_pivot_ = equations().smallest_pivot();
    scales_.include(start_, first_rates_, 0.0);
    scales_.include(start_, first_rates_, first_step(kOrderOfFirstStep));
}

double CountedEquations::first_step(int order) const {
    return scales_.first_step(first_rates_, tolerance_, order);
}

RowsVerdict CountedEquations::evaluate_counted(double t, const double* y, double* y_dot) {
    ++evaluations_;
    return equations().evaluate(t, y, y_dot);
}

void CountedEquations::project(double t, double* y) {
    ++projections_;
    equations().project(t, y);
}

bool CountedEquations::project_drifted(double t, double* y) {
    if (!has_loops()) { return false; }
    if (equations().violation(t, y).first <= kDriftShare * tolerance_) { return false; }
    project(t, y);
    return true;
}

void CountedEquations::evaluate_on_constraints(double t, const double* y, double* y_dot) {
    moved_.assign(y, y + size());
    project(t, moved_.data());
    evaluate_counted(t, moved_.data(), y_dot);
}

bool CountedEquations::evaluate(double t, const double* y, double* y_dot) {
    const bool known = t == last_t_ && std::equal(last_y_.begin(), last_y_.end(), y, y + size());
    if (!known) {
        last_t_ = t;
        last_y_.assign(y, y + size());
        last_rates_.resize(last_y_.size());
        evaluate_anew();
    }
    std::ranges::copy(last_rates_, y_dot);
    return std::ranges::all_of(last_rates_, [](double x) { return std::isfinite(x); });
}

void CountedEquations::evaluate_anew() {
    const double* y = last_y_.data();
    if (has_loops() && held_ == Held::within) {
        evaluate_on_constraints(last_t_, y, last_rates_.data());
        for (std::size_t k = 0; k < last_rates_.size(); ++k) {
            last_rates_[k] -= kComesBack * (y[k] - moved_[k]);
        }
        return;
    }
    const RowsVerdict verdict = evaluate_counted(last_t_, y, last_rates_.data());
    // beside a singular position a small residual becomes a large acceleration
    if (has_loops() && !(verdict.smallest_pivot >= kNearSingular * regular_pivot_)) {
        evaluate_on_constraints(last_t_, y, last_rates_.data());
    }
}

void CountedEquations::follow(double t, const std::vector<double>& y) {
    equations().follow_turns(t, y.data());
    scales_.include(y, first_rates_, 0.0);
    if (!has_loops()) { return; }
    const double pivot = equations().smallest_pivot();
    regular_pivot_ = std::max(regular_pivot_, pivot);
    if (pivot < kRowsTurnBad * pivot_at_choice_) { choose_rows_again(t, y.data()); }
}

/// Chooses other rows if these are better conditioned. If all are equally bad, the position is singular.
void CountedEquations::choose_rows_again(double t, const double* y) {
    const int left_out = equations().rows_left_out();
    const double before = equations().smallest_pivot();
    if (!equations().choose_rows(t, y)) { return; }
    std::vector<double> rates(start_.size());
    const double pivot = evaluate_counted(t, y, rates.data()).smallest_pivot;
    if (equations().rows_left_out() == left_out && pivot > 10.0 * before) {
        pivot_at_choice_ = pivot;
        last_y_.clear();
        return;
    }
    equations().take_back_rows();
}

}  // namespace jw::peers
